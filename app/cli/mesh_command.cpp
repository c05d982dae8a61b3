#include <CLI/CLI.hpp>
#include <cstdio>
#include <map>
#include <memory>

#include "app/cli/commands.h"
#include "app/output/mesh_statistics.h"
#include "app/output/output.h"
#include "app/shared/progress.h"
#include "sim/core/error.h"
#include "sim/core/replace_file.h"
#include "sim/mesh/mesh_report.h"
#include "sim/mesh/read_mesh.h"
#include "sim/mesh/write_mesh.h"
#include "sim/meshing/mesh_cache.h"

namespace griffith::app {
namespace {

/// Options of `mesh`: a surface to fill or tets to examine.
struct MeshOptions {
  std::filesystem::path input, output;  ///< without an output only the table of quality is printed
  MeshingOptions meshing;
  double scale = 1;                  ///< meters per unit of the file
  double time_limit = 300;           ///< for TetGen [s]
  std::int64_t memory_limit = 8192;  ///< for TetGen [MB]
  bool cache = true;                 ///< uses cached meshes
  std::filesystem::path report;      ///< JSON; empty: none
};

void check_output_path(const std::filesystem::path& path) {
  const std::filesystem::path kind = path.extension();
  if (kind != ".msh" && kind != ".vtu" && kind != ".node" && kind != ".ele")
    throw InputError(path.string(), "has no supported mesh extension", "use .msh, .vtu or .node");
  check_replaceable(path);
}

void write_mesh(const std::filesystem::path& path, const TetSoup& soup) {
  if (path.extension() == ".msh") return write_gmsh(path, soup);
  if (path.extension() != ".vtu") return write_tetgen(path, soup);
  std::vector<std::array<NodeId, 4>> tets;
  for (const auto& [a, b, c, d] : soup.tets) tets.push_back({NodeId(a), NodeId(b), NodeId(c), NodeId(d)});
  write_vtu(path, soup.points, tets);
}

SurfaceMesh fill(const MeshOptions& options) {
  constexpr std::int64_t kMegabyte = 1 << 20;
  StageProgress progress;
  MeshingSetup setup;
  setup.name = options.input.string();
  setup.limits = {options.time_limit, options.memory_limit * kMegabyte};
  if (options.cache) setup.cache = default_mesh_cache();
  setup.monitor.stage = [&](std::string_view stage) { progress.enter(stage); };
  setup.monitor.enter("Reading the surface");
  return mesh_surface(read_surface(options.input, options.scale, setup.monitor), options.meshing, setup);
}

void warn_of(const std::vector<std::string>& findings, const MeshOptions& options) {
  for (const std::string& finding : findings) print_error("warning: %s: %s\n", options.input.c_str(), finding.c_str());
}

/// Writes the requested mesh and report.
void write_outputs(const MeshOptions& options, const TetSoup& soup, const std::string& report, Outputs& outputs) {
  if (!options.output.empty()) outputs.write([&] { write_mesh(options.output, soup); });
  if (!options.report.empty()) outputs.write([&] { replace_file(options.report, report); });
}

/// Prints the quality of tets, and converts them if an output is given.
void describe_tets(const MeshOptions& options) {
  CellReport cells;
  TetSoup soup = read_mesh(options.input, &cells);
  for (Vec3& point : soup.points) point *= options.scale;
  std::vector<std::string> found = findings(cells);
  const std::vector<std::string> repairs = findings(prepare(soup, options.input.string()));
  found.insert(found.end(), repairs.begin(), repairs.end());
  warn_of(found, options);
  const MeshQuality quality = mesh_quality(soup);
  Outputs outputs;
  write_outputs(options, soup, mesh_statistics_json(found, quality), outputs);
  print("tetrahedra       nothing to fill; scenes can use the file as the shape {\"mesh\": {\"path\": \"%s\"}}\n%s",
        options.input.filename().c_str(), quality_text(quality).c_str());
  outputs.finish();
}

void make_mesh(const MeshOptions& options) {
  if (!options.output.empty()) check_output_path(options.output);
  if (!options.report.empty()) check_replaceable(options.report);
  if (is_mesh_path(options.input)) return describe_tets(options);
  const SurfaceMesh mesh = fill(options);
  warn_of(mesh.findings, options);
  const MeshQuality quality = mesh_quality(mesh.soup);
  Outputs outputs;
  write_outputs(options, mesh.soup, mesh_statistics_json(mesh, quality), outputs);
  print("surface          %d triangles, %d shell%s, %.6g m3\nmethod           %s%s\n%s", mesh.surface_report.triangles,
        mesh.surface_report.shells, mesh.surface_report.shells == 1 ? "" : "s", mesh.surface_report.volume,
        method_name(mesh.method), mesh.from_cache ? ", from the cache" : "", quality_text(quality).c_str());
  outputs.finish();
}

/// Adds the options of the meshing.
void add_meshing(CLI::App& command, MeshingOptions& meshing) {
  const std::map<std::string, MeshingMethod> methods = {{"automatic", MeshingMethod::automatic},
                                                        {"tetgen", MeshingMethod::tetgen},
                                                        {"volumetric", MeshingMethod::volumetric}};
  command.add_option("--element-size", meshing.element_size, "Edge of a tetrahedron [m]; default: 1/20 of the size")
      ->check(CLI::Range(1e-6, 1e5))
      ->type_name("M");
  command
      .add_option("--method", meshing.method,
                  "automatic (the default), tetgen (keeps the surface's triangles) or volumetric (accepts any surface)")
      ->transform(CLI::CheckedTransformer(methods).description(""))
      ->type_name("NAME");
  command
      .add_option("--grading", meshing.grading, "Ratio of the longest edges inside to those at the surface; default: 1")
      ->check(CLI::Range(1.0, 100.0))
      ->type_name("G");
  command
      .add_option("--quality", meshing.radius_edge_ratio,
                  "TetGen: largest ratio of circumradius to shortest edge; default: 1.4")
      ->check(CLI::Range(1.1, 10.0))
      ->type_name("Q");
  command
      .add_option("--min-dihedral", meshing.min_dihedral_angle,
                  "TetGen: smallest dihedral angle to aim for; default: 10")
      ->check(CLI::Range(0.0, 18.0))
      ->type_name("DEGREES");
}

}  // namespace

Command add_mesh(CLI::App& program) {
  CLI::App* command = program.add_subcommand("mesh", "Fill a surface with tetrahedra");
  const auto options = std::make_shared<MeshOptions>();
  command
      ->add_option("SURFACE", options->input,
                   "Surface: .obj, .stl, .ply, .off, .gltf or .glb; or tetrahedra, for a report of their quality")
      ->required()
      ->type_name("FILE");
  command
      ->add_option("-o,--output", options->output,
                   "Mesh to write: .msh, .vtu or .node; default: only the table of quality")
      ->type_name("FILE");
  add_meshing(*command, options->meshing);
  command->add_option("--scale", options->scale, "Meters per unit of the file; 1 if not given")
      ->check(CLI::Range(1e-9, 1e6))
      ->type_name("S");
  command->add_option("--time-limit", options->time_limit, "TetGen: limit in seconds; default: 300")
      ->check(CLI::Range(0.01, 1e6))
      ->type_name("S");
  command->add_option("--memory-limit", options->memory_limit, "TetGen: limit in megabytes; default: 8192")
      ->check(CLI::Range(16, 1 << 20))
      ->type_name("MB");
  command->add_option("--report", options->report, "Write findings and quality as JSON")->type_name("FILE");
  command->add_flag("--cache,!--no-cache", options->cache, "Use cached meshes; default: on");
  add_threads(*command);
  command->footer(
      "Examples:\n"
      "  griffith mesh vase.obj -o vase.msh\n"
      "  griffith mesh vase.msh\n"
      "  griffith mesh bunny.stl --scale 0.001 --element-size 0.005 --method volumetric -o bunny.vtu --report "
      "bunny.json");
  return {command, [options] {
            make_mesh(*options);
            return kDone;
          }};
}

}  // namespace griffith::app
