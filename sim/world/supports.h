#pragma once

#include "sim/scene/boundary_condition.h"
#include "sim/world/rest_body.h"

namespace griffith {

struct WorldState;

/// A support and what it holds.
struct PlacedSupport {
  Support support;
  std::vector<TetCorner> corners;  ///< all at its nodes: where a crack parts one, it holds both
};

/// Finds the nodes of a body's supports, once; one that holds none becomes a finding. Then update_supports().
void place_supports(WorldState& world, int scene_body, const RestBody& body);

/// Sets the constraints of all held nodes for a step of `dt` from `time` [s]. Prescribed supports that stop within the
/// step move slower, so that they get exactly as far as they should. Which directions are blocked never changes.
void update_supports(WorldState& world, double time, double dt);

}  // namespace griffith
