#include "app/editor/picking.h"

#include <algorithm>
#include <optional>

#include "sim/geometry/triangle.h"
#include "sim/mesh/tet_mesh.h"

namespace griffith::app {

NodeId nearest_corner(const ShownMesh& shown, TetId tet, const render::Ray& ray) {
  const Vec3 origin = ray.origin.cast<double>(), direction = ray.direction.cast<double>();
  const auto corner = [&](int i) { return shown.positions[shown.frame.elements.tets[tet][i]]; };
  std::optional<double> entry;
  for (const auto& face : kTetFaces) {
    const std::optional<double> t = triangle_hit(origin, direction, corner(face[0]), corner(face[1]), corner(face[2]));
    if (t && (!entry || *t < *entry)) entry = t;
  }
  const auto distance = [&](NodeId node) {
    const Vec3 arm = shown.positions[node] - origin;
    return (arm - entry.value_or(arm.dot(direction)) * direction).norm();
  };
  return *std::ranges::min_element(shown.frame.elements.tets[tet], {}, distance);
}

}  // namespace griffith::app
