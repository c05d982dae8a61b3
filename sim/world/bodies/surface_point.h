#pragma once

#include <array>
#include <vector>

#include "sim/world/state/world_state.h"

namespace griffith {

/// Point of a body's surface: corners of a face and their barycentric weights, whose sum is 1.
struct SurfacePoint {
  std::array<NodeId, 3> nodes;
  Vec3 weights = Vec3::Zero();

  /// Returns the value there of what is given per node of the mesh.
  Vec3 interpolate(const std::vector<Vec3>& values) const {
    Vec3 value = Vec3::Zero();
    for (int i = 0; i < 3; ++i) value += weights[i] * values[nodes[i]];
    return value;
  }
};

/// Finds points of a body's present surface (world space); void when its nodes move.
class SurfaceSearch {
 public:
  SurfaceSearch(const WorldState& world, const Body& body);
  /// Returns the point of the surface closest to `position` [m]; if there are several, the one on the first face.
  SurfacePoint closest(const Vec3& position) const;

 private:
  const WorldState& world_;
  const Body& body_;
  NodeVectors centers_;    // of the faces
  Eigen::VectorXd radii_;  // radii of spheres about the centers that contain their faces
};

}  // namespace griffith
