#include "sim/meshing/mesh_surface.h"

#include <cmath>
#include <cstdio>
#include <optional>

#include "sim/core/error.h"
#include "sim/mesh/mesh_limits.h"
#include "sim/mesh/mesh_report.h"
#include "sim/mesh/topology.h"
#include "sim/meshing/mesh_cache.h"
#include "sim/meshing/tetgen.h"
#include "sim/meshing/triangle_tree.h"
#include "sim/meshing/volumetric.h"

namespace griffith {
namespace {

/// Relative difference in volume from the surface that is reported.
constexpr double kVolumeTolerance = 0.05;

/// Removes tets outside the surface, since TetGen fills cavities too.
void remove_cavities(TetSoup& soup, const TriangleSurface& surface) {
  const TriangleTree tree(surface);
  std::erase_if(soup.tets, [&](const auto& tet) {
    const Vec3 middle = (soup.points[tet[0]] + soup.points[tet[1]] + soup.points[tet[2]] + soup.points[tet[3]]) / 4;
    return std::abs(tree.winding_number(middle)) < 0.5;
  });
}

/// Returns the reason to skip TetGen; empty if there is none.
std::string unsound(const SurfaceReport& report) {
  if (report.boundary_edges > 0) return "the surface is open";
  if (report.crowded_edges > 0) return "edges belong to more than two triangles";
  if (report.one_sided_shells > 0) return "the surface cannot be oriented";
  if (report.self_intersections.pairs > 0) return "the surface passes through itself";
  return {};
}

TetgenResult try_tetgen(const TriangleSurface& surface, const SurfaceReport& report, const MeshingOptions& options,
                        const MeshingSetup& setup) {
  TetgenResult result;
  result.refusal = unsound(report);
  if (!result.refusal.empty()) return result;
  result = run_tetgen(surface, options, element_size_for(report, options), setup.limits, setup.monitor);
  if (!result.refusal.empty()) return result;
  if (report.shells > 1) remove_cavities(result.soup, surface);
  try {
    prepare(result.soup, "TetGen's mesh");
  } catch (const InputError& error) {
    result.refusal = error.problem();
  }
  return result;
}

void require_reasonable_count(double volume, double element_size, const MeshingSetup& setup) {
  const double tets = 12 * std::abs(volume) / (element_size * element_size * element_size);
  if (tets > static_cast<double>(kMaxTets))
    throw InputError(setup.name, std::string("would take more than ") + kMaxTetsText, "use a larger element size");
}

/// Returns the reason why the lattice replaced TetGen; else empty.
std::string instead_of_tetgen(const FilledSurface& filled) {
  return filled.refusal.empty() ? "" : "; the method is volumetric because " + filled.refusal;
}

std::string for_tetgen_or(const FilledSurface& filled, const std::string& remedy) {
  return filled.remedy.empty() ? remedy : filled.remedy + ", or " + remedy;
}

FilledSurface fill(const TriangleSurface& surface, const SurfaceReport& report, const MeshingOptions& options,
                   const MeshingSetup& setup) {
  const double element_size = element_size_for(report, options);
  require_reasonable_count(report.volume, element_size, setup);
  FilledSurface filled;
  if (options.method != MeshingMethod::volumetric) {
    TetgenResult result = try_tetgen(surface, report, options, setup);
    if (result.refusal.empty()) {
      filled.soup = std::move(result.soup);
      filled.method = MeshingMethod::tetgen;
      return filled;
    }
    if (options.method == MeshingMethod::tetgen)
      throw InputError(
          setup.name, "TetGen cannot mesh it: " + result.refusal,
          (result.remedy.empty() ? "repair the surface" : result.remedy) + ", or use the method volumetric");
    filled.refusal = result.refusal;
    filled.remedy = result.remedy;
  }
  filled.soup = stuff_surface(surface, element_size, options.grading, setup.name, setup.monitor);
  if (filled.soup.tets.empty()) {
    const bool sound = unsound(report).empty();
    throw InputError(
        setup.name,
        (sound ? "is thinner than the elements everywhere" : "has no inside that could be filled") +
            instead_of_tetgen(filled),
        sound ? for_tetgen_or(filled, "give a smaller element size") : "close its holes, or give it a thickness");
  }
  prepare(filled.soup, setup.name);
  filled.parting = find_parting(surface, report, filled.soup, options, element_size, setup);
  return filled;
}

/// Like fill(), but uses an earlier result for the same surface and options if there is one.
FilledSurface fill_or_recall(const TriangleSurface& surface, const SurfaceReport& report, const MeshingOptions& options,
                             const MeshingSetup& setup, bool& from_cache) {
  if (setup.cache.empty()) return fill(surface, report, options, setup);
  const std::filesystem::path entry = cache_entry(setup.cache, surface, options);
  if (auto filled = read_cache_entry(entry)) {
    from_cache = true;
    return std::move(*filled);
  }
  FilledSurface filled = fill(surface, report, options, setup);
  if (filled.remedy.empty()) write_cache_entry(entry, filled);
  return filled;
}

double volume_of(const TetSoup& soup) {
  double volume = 0;
  for (const auto& [a, b, c, d] : soup.tets)
    volume += signed_volume(soup.points[a], soup.points[b], soup.points[c], soup.points[d]);
  return volume;
}

/// Returns the relative difference in volume of the mesh from the surface; 0 if the surface has no reliable volume.
double change_in_volume(const SurfaceReport& report, const FilledSurface& filled) {
  if (!unsound(report).empty() || report.shells > 1) return 0;
  return volume_of(filled.soup) / report.volume - 1;
}

/// Returns the thickness of a thin wall, or a third of a ball's radius, an upper limit of the element size [m].
double mean_thickness(const SurfaceReport& report) { return 2 * std::abs(report.volume) / report.area; }

/// Returns a sentence on the volume of the mesh; empty if there is nothing to report.
std::string volume_finding(const SurfaceReport& report, const FilledSurface& filled) {
  const double change = change_in_volume(report, filled);
  if (std::abs(change) < kVolumeTolerance) return {};
  char text[200];
  std::snprintf(
      text, sizeof text,
      "the mesh has %.0f %% %s volume than the surface: an element size below %.2g m, its mean thickness, fits "
      "better",
      100 * std::abs(change), change < 0 ? "less" : "more", mean_thickness(report));
  return text;
}

/// Throws if the mesh has lost most of the volume. A lattice misses walls thinner than its elements, as of a vase.
void require_enough_volume(const SurfaceReport& report, const FilledSurface& filled, const MeshingSetup& setup) {
  constexpr double kMaxLost = 0.5;
  const double change = change_in_volume(report, filled);
  if (change > -kMaxLost) return;
  char problem[120], remedy[120];
  std::snprintf(problem, sizeof problem, "has walls thinner than the elements: %.0f %% of its volume would be lost",
                -100 * change);
  std::snprintf(remedy, sizeof remedy, "give an element size below %.2g m, its mean thickness, or the method tetgen",
                mean_thickness(report));
  throw InputError(setup.name, problem + instead_of_tetgen(filled), for_tetgen_or(filled, remedy));
}

/// Returns a sentence on many more tets than their size suggests; empty if there is nothing to report. A thin wall
/// needs many.
std::string count_finding(const SurfaceReport& report, const FilledSurface& filled, double element_size) {
  constexpr double kMany = 8;
  const double minimum = 6 * std::sqrt(2.0) * report.volume / std::pow(element_size, 3);
  const double many = static_cast<double>(filled.soup.tets.size()) / minimum;
  if (filled.method != MeshingMethod::tetgen || many < kMany || mean_thickness(report) < element_size) return {};
  char text[200];
  std::snprintf(
      text, sizeof text,
      "TetGen kept small triangles of the surface and made %zu tetrahedra, %.0f times as many as their size asks "
      "for: the method volumetric makes fewer",
      filled.soup.tets.size(), many);
  return text;
}

std::vector<std::string> findings_of(const SurfaceReport& report, const FilledSurface& filled, double element_size) {
  std::vector<std::string> list = findings(report);
  if (!filled.refusal.empty())
    list.push_back("meshed by the method volumetric, on a lattice of equal elements, because " + filled.refusal);
  list.push_back(finding(filled.parting));
  list.push_back(volume_finding(report, filled));
  list.push_back(count_finding(report, filled, element_size));
  std::erase(list, "");
  return list;
}

}  // namespace

double element_size_for(const SurfaceReport& report, const MeshingOptions& options) {
  constexpr double kFractionOfDiagonal = 0.05;
  return options.element_size.value_or(kFractionOfDiagonal * report.size());
}

SurfaceMesh mesh_surface(TriangleSurface surface, const MeshingOptions& options, const MeshingSetup& setup) {
  setup.monitor.enter("Checking the surface");
  SurfaceMesh mesh;
  mesh.surface_report = prepare_surface(surface, setup.name);
  FilledSurface filled = fill_or_recall(surface, mesh.surface_report, options, setup, mesh.from_cache);
  require_enough_volume(mesh.surface_report, filled, setup);
  mesh.findings = findings_of(mesh.surface_report, filled, element_size_for(mesh.surface_report, options));
  mesh.soup = std::move(filled.soup);
  mesh.method = filled.method;
  mesh.surface = std::move(surface);
  return mesh;
}

}  // namespace griffith
