#include <cstdio>

#include "app/output/mesh_statistics.h"
#include "app/output/output.h"
#include "app/shared/command_options.h"
#include "app/shared/progress.h"
#include "sim/core/error.h"
#include "sim/core/replace_file.h"
#include "sim/mesh/write_mesh.h"
#include "sim/meshing/mesh_cache.h"

namespace griffith::app {
namespace {

void check_output_path(const std::filesystem::path& path) {
  const std::filesystem::path kind = path.extension();
  if (kind != ".msh" && kind != ".vtu" && kind != ".node" && kind != ".ele")
    throw InputError(path.string(), "is no kind of mesh file that is written", "end its name in .msh, .vtu or .node");
  check_replaceable(path);
}

void write_mesh(const std::filesystem::path& path, const TetSoup& soup) {
  if (path.extension() == ".msh") return write_gmsh(path, soup);
  if (path.extension() != ".vtu") return write_tetgen(path, soup);
  std::vector<std::array<NodeId, 4>> tets;
  for (const auto& [a, b, c, d] : soup.tets) tets.push_back({NodeId(a), NodeId(b), NodeId(c), NodeId(d)});
  write_vtu(path, soup.points, tets);
}

SurfaceMesh run(const MeshOptions& options) {
  constexpr std::int64_t kMegabyte = 1 << 20;
  StageProgress progress;
  MeshingSetup setup;
  setup.name = options.surface.string();
  setup.limits = {options.time_limit, options.memory_limit * kMegabyte};
  if (options.cache) setup.cache = default_mesh_cache();
  setup.monitor.stage = [&](std::string_view stage) { progress.enter(stage); };
  setup.monitor.enter("Reading the surface");
  return mesh_surface(read_surface(options.surface, options.scale, setup.monitor), options.meshing, setup);
}

}  // namespace

void mesh_command(const MeshOptions& options) {
  check_output_path(options.output);
  if (!options.report.empty()) check_replaceable(options.report);
  const SurfaceMesh mesh = run(options);
  for (const std::string& finding : mesh.findings)
    std::fprintf(stderr, "warning: %s: %s\n", options.surface.c_str(), finding.c_str());
  const MeshQuality quality = mesh_quality(mesh.soup);
  Outputs outputs;
  outputs.write([&] { write_mesh(options.output, mesh.soup); });
  if (!options.report.empty())
    outputs.write([&] { replace_file(options.report, mesh_statistics_json(mesh, quality)); });
  std::printf("surface          %d triangles, %d shell%s, %.6g m3\nmethod           %s%s\n%s",
              mesh.surface_report.triangles, mesh.surface_report.shells, mesh.surface_report.shells == 1 ? "" : "s",
              mesh.surface_report.volume, method_name(mesh.method), mesh.from_cache ? ", made before" : "",
              quality_text(quality).c_str());
  outputs.finish();
}

}  // namespace griffith::app
