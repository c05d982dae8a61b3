#pragma once

#include <span>
#include <vector>

#include "sim/contact/contact_world.h"

namespace griffith {

/// A convex piece of a body.
struct ConvexPiece {
  std::vector<int> corners;  ///< of the body's points, at least one
  double volume = 0;         ///< [m³]
};

/// As convex_parts() of tets, for a body that is put together from pieces of any kind.
std::vector<ConvexPart> convex_parts(std::span<const Vec3> points, std::span<const ConvexPiece> pieces,
                                     double fill = 0.9);

}  // namespace griffith
