#pragma once

#include "sim/world/world_state.h"

namespace griffith {

/// Where a body, or nodes of it, would be if they were not deformed: turned from rest about a centre.
struct Placement {
  Vec3 center = Vec3::Zero(), rest_center = Vec3::Zero();  ///< the same point now and at rest [m]
  Mat3 turn = Mat3::Identity();

  Vec3 to_world(const Vec3& rest) const { return center + turn * (rest - rest_center); }
};

/// The placement that fits nodes best, by their masses.
Placement placement_of(const WorldState& world, const std::vector<NodeId>& nodes);

}  // namespace griffith
