#pragma once

#include <set>
#include <vector>

#include "sim/fracture/split.h"
#include "sim/world/fracture/subdivision.h"
#include "sim/world/state/world_state.h"

namespace griffith {

/// Opens the mesh where the utilization exceeds 1, worst first; separated pieces become bodies. Cracks beyond the
/// budget open in the next step. New cracks start no closer to each other than a wave travels in the `substep` [s].
void open_cracks(WorldState& world, double substep);

/// Cracks of a step, until the pieces are known.
struct Opened {
  std::set<BodyId> bodies;
  MotionsBefore motions;     ///< motions of free bodies before they were remeshed
  std::set<NodeId> waiting;  ///< these wait until their stress beside a split is known again
  std::vector<NodeCopy> copies;
  std::vector<EdgeCopy> edge_copies;
  std::vector<TetId> parted;  ///< tets that lost a neighbor
  std::size_t first_event = 0;
};

/// True if crack() may separate a node: its plane may have all elements around it on one side.
bool may_crack(const WorldState& world, NodeId node);

/// Opens the mesh at an overloaded node across its separation plane, or releases it from its support. Returns true if
/// it did. Requires the present states of the node's elements.
bool crack(WorldState& world, NodeId node, Opened& opened);

/// Makes bodies, splinters and events of the cracks.
void part_opened(WorldState& world, const Opened& opened);

}  // namespace griffith
