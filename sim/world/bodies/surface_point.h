#pragma once

#include <array>

#include "sim/world/world_state.h"

namespace griffith {

/// A point of a body's surface: corners of a face and their barycentric weights (they add up to 1).
struct SurfacePoint {
  std::array<NodeId, 3> nodes;
  Vec3 weights = Vec3::Zero();
};

/// Finds points of a body's present surface (world space); void when its nodes move.
class SurfaceSearch {
 public:
  SurfaceSearch(const WorldState& world, const Body& body);
  /// The point of the surface closest to `position` [m], of several the one on the first face.
  SurfacePoint closest(const Vec3& position) const;

 private:
  const WorldState& world_;
  const Body& body_;
  NodeVectors centers_;    // of the faces
  Eigen::VectorXd radii_;  // of spheres about the centers that hold their faces
};

}  // namespace griffith
