#pragma once

#include <span>
#include <vector>

#include "sim/contact/contact_world.h"

namespace griffith {

/// Convex piece of a body.
struct ConvexPiece {
  std::vector<int> corners;  ///< indices of the body's points, at least one
  double volume = 0;         ///< [m³]
};

/// Divides a body made of convex pieces as convex_parts() divides a large one made of tets.
std::vector<ConvexPart> convex_parts(std::span<const Vec3> points, std::span<const Vec3> rest_points,
                                     std::span<const ConvexPiece> pieces, double fill = 0.97);

}  // namespace griffith
