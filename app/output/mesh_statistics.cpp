#include "app/output/mesh_statistics.h"

#include <nlohmann/json.hpp>

#include "app/shared/components.h"

namespace griffith::app {
namespace {

using Json = nlohmann::ordered_json;

Json surface_json(const SurfaceReport& report) {
  return {{"points", report.points},
          {"triangles", report.triangles},
          {"shells", report.shells},
          {"closed", report.closed()},
          {"volume", report.volume},
          {"area", report.area},
          {"minimum", components(report.minimum)},
          {"maximum", components(report.maximum)},
          {"removed_triangles", report.removed_triangles},
          {"flipped_triangles", report.flipped_triangles},
          {"inverted_shells", report.inverted_shells},
          {"flat_triangles", report.flat_triangles},
          {"boundary_edges", report.boundary_edges},
          {"boundary_loops", report.boundary_loops},
          {"crowded_edges", report.crowded_edges},
          {"pinched_points", report.pinched_points},
          {"one_sided_shells", report.one_sided_shells},
          {"self_intersections", report.self_intersections.pairs}};
}

Json quality_json(const MeshQuality& quality) {
  return {{"nodes", quality.nodes},
          {"tets", quality.tets},
          {"surface_triangles", quality.surface_triangles},
          {"volume", quality.volume},
          {"shortest_edge", quality.shortest_edge},
          {"mean_edge", quality.mean_edge},
          {"longest_edge", quality.longest_edge},
          {"min_dihedral_angle", quality.min_dihedral},
          {"max_dihedral_angle", quality.max_dihedral},
          {"dihedral_angles_by_10_degrees", quality.dihedrals},
          {"mean_aspect_ratio", quality.mean_aspect_ratio},
          {"worst_aspect_ratio", quality.worst_aspect_ratio},
          {"aspect_ratios_from_1_by_half", quality.aspect_ratios}};
}

}  // namespace

const char* method_name(MeshingMethod method) { return method == MeshingMethod::tetgen ? "tetgen" : "volumetric"; }

std::string mesh_statistics_json(const SurfaceMesh& mesh, const MeshQuality& quality) {
  const Json json = {{"method", method_name(mesh.method)},
                     {"from_cache", mesh.from_cache},
                     {"findings", mesh.findings},
                     {"surface", surface_json(mesh.surface_report)},
                     {"mesh", quality_json(quality)}};
  return json.dump(2) + "\n";
}

std::string mesh_statistics_json(const std::vector<std::string>& findings, const MeshQuality& quality) {
  return Json{{"findings", findings}, {"mesh", quality_json(quality)}}.dump(2) + "\n";
}

}  // namespace griffith::app
