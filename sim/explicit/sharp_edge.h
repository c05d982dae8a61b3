#pragma once

#include <array>
#include <optional>

#include "sim/core/linear_algebra.h"

namespace griffith::explicit_dynamics {

/// Convex edge of a solid, with the unit outward normals of its two faces.
struct SharpEdge {
  std::array<Vec3, 2> ends;  ///< [m]
  std::array<Vec3, 2> normals;

  double length() const { return (ends[1] - ends[0]).norm(); }
};

/// True if the normals of two faces differ so much that their edge can strike another one.
bool are_sharp(const Vec3& first, const Vec3& second);

/// Contact of two edges that cross.
struct EdgeContact {
  std::array<double, 2> along;  ///< place on each edge, as a fraction of its length, 0..1
  Vec3 normal;                  ///< unit, out of the first solid
  double depth = 0;             ///< overlap, >= 0 [m]
};

/// Result of a test of two edges.
struct EdgeTest {
  std::optional<EdgeContact> contact;
  double clear = 0;  ///< distance that they may still approach without contact [m], if there is none
};

/// Tests if two edges have passed each other, each from outside the other's solid, by at most `deepest` [m]. Contacts
/// at their ends, and of parallel edges, are left to corners and faces.
EdgeTest test_edges(const SharpEdge& first, const SharpEdge& second, double deepest);

}  // namespace griffith::explicit_dynamics
