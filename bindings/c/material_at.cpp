#include "bindings/c/material_at.h"

#include <Eigen/LU>
#include <limits>

#include "sim/geometry/triangle.h"
#include "sim/mesh/tet_mesh.h"

namespace griffith::c {
namespace {

/// Returns the weights of corners 1 to 3 of a tet at a place.
Vec3 weights_at(const Frame& frame, TetId tet, const Vec3& place) {
  const std::array<NodeId, 4>& corners = frame.elements.tets[tet];
  const auto at = [&](int corner) { return frame.nodes.positions[corners[corner]]; };
  Mat3 edges;
  for (int i = 0; i < 3; ++i) edges.col(i) = at(i + 1) - at(0);
  return edges.inverse() * (place - at(0));
}

bool is_inside(const Vec3& weights) { return weights.minCoeff() >= 0 && weights.sum() <= 1; }

/// Point of a face with its distance from a place [m].
struct NearPoint {
  double distance = std::numeric_limits<double>::infinity();
  MaterialPlace place;
};

void take_nearer(const Frame& frame, TetId tet, std::size_t face, const Vec3& place, NearPoint& nearest) {
  const std::array<NodeId, 4>& corners = frame.elements.tets[tet];
  std::array<Vec3, 3> triangle;
  for (std::size_t i = 0; i < 3; ++i) triangle[i] = frame.nodes.positions[corners[kTetFaces[face][i]]];
  const Vec3 of_face = closest_on_triangle(place, triangle);
  const Vec3 point = of_face[0] * triangle[0] + of_face[1] * triangle[1] + of_face[2] * triangle[2];
  if (!((point - place).norm() < nearest.distance)) return;
  nearest = {(point - place).norm(), {tet.index(), Vec3::Zero()}};
  for (int i = 0; i < 3; ++i)
    if (const int corner = kTetFaces[face][i]; corner > 0) nearest.place.weights[corner - 1] = of_face[i];
}

}  // namespace

MaterialPlace material_at(const Frame& frame, const Vec3& place) {
  NearPoint nearest;
  for (std::size_t i = 0; i < frame.elements.tets.size(); ++i) {
    const TetId tet(i);
    if (const Vec3 weights = weights_at(frame, tet, place); is_inside(weights)) return {tet.index(), weights};
    for (std::size_t face = 0; face < 4; ++face)
      if (!frame.elements.neighbors[tet][face].valid()) take_nearer(frame, tet, face, place, nearest);
  }
  return nearest.place;
}

}  // namespace griffith::c
