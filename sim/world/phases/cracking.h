#pragma once

#include <set>
#include <vector>

#include "sim/fracture/split.h"
#include "sim/world/phases/subdivision.h"
#include "sim/world/world_state.h"

namespace griffith {

/// What cracked, until the pieces are known.
struct Opened {
  std::set<BodyId> bodies;
  MotionsBefore motions;     ///< of free bodies that were remeshed
  std::set<NodeId> waiting;  ///< a split relieves its neighbourhood: these wait until their stress is known again
  std::vector<NodeCopy> copies;
  std::vector<EdgeCopy> edge_copies;
  std::vector<TetId> parted;  ///< tets that lost a neighbor
  std::size_t first_event = 0;
};

/// Whether crack() would find anything to part at a node: its plane may leave all elements round it on one side.
bool may_crack(const WorldState& world, NodeId node);

/// Opens the mesh at an overloaded node, across the plane of its separation, or tears it off its support; whether
/// anything was parted. Elements at the node need their present states.
bool crack(WorldState& world, NodeId node, Opened& opened);

/// Bodies, splinters and events of what has cracked.
void part_opened(WorldState& world, const Opened& opened);

}  // namespace griffith
