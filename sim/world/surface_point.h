#pragma once

#include <array>

#include "sim/world/world_state.h"

namespace griffith {

/// A point of a body's surface: corners of a face and their barycentric weights (they add up to 1).
struct SurfacePoint {
  std::array<NodeId, 3> nodes;
  Vec3 weights = Vec3::Zero();
};

/// Barycentric weights of the point of triangle abc closest to p.
Vec3 closest_on_triangle(const Vec3& p, const std::array<Vec3, 3>& corners);

/// The point of the body's present surface closest to `position` (world space).
SurfacePoint closest_surface_point(const WorldState& world, const Body& body, const Vec3& position);

}  // namespace griffith
