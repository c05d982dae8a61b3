#pragma once

#include <span>

#include "sim/core/ids.h"
#include "sim/core/linear_algebra.h"

namespace griffith {

/// Undeformed placement of points: rotated from rest about a center.
struct Placement {
  Vec3 center = Vec3::Zero(), rest_center = Vec3::Zero();  ///< the same point at present and at rest [m]
  Mat3 turn = Mat3::Identity();

  Vec3 to_world(const Vec3& rest) const { return center + turn * (rest - rest_center); }
};

/// Returns the rotation that fits arms to others best, in least squares, from the sum of w · present arm · (arm at
/// rest)ᵀ over all of them (Kabsch 1976).
Mat3 best_rotation(const Mat3& correlation);

/// Returns the placement that fits `nodes` best, in least squares. Per node of the mesh: positions at rest and at
/// present [m] and weights, of which those of `nodes` have a sum above zero.
Placement best_placement(std::span<const Vec3> rest, std::span<const Vec3> now, std::span<const double> weights,
                         std::span<const NodeId> nodes);

}  // namespace griffith
