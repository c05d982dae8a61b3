#pragma once

#include <span>

#include "sim/core/ids.h"
#include "sim/core/linear_algebra.h"

namespace griffith {

/// Where points would be if nothing were deformed: turned from rest about a centre.
struct Placement {
  Vec3 center = Vec3::Zero(), rest_center = Vec3::Zero();  ///< the same point now and at rest [m]
  Mat3 turn = Mat3::Identity();

  Vec3 to_world(const Vec3& rest) const { return center + turn * (rest - rest_center); }
};

/// The rotation that turns arms closest to others, in least squares, from the sum of w · arm now · (arm at rest)ᵀ over
/// all of them (Kabsch 1976).
Mat3 best_rotation(const Mat3& correlation);

/// The placement closest to `nodes`, in least squares. Per node of the mesh: places at rest and now [m] and weights, of
/// which those of `nodes` have a sum above zero.
Placement best_placement(std::span<const Vec3> rest, std::span<const Vec3> now, std::span<const double> weights,
                         std::span<const NodeId> nodes);

}  // namespace griffith
