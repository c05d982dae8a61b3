#pragma once

#include <vector>

#include "sim/world/state/world_state.h"

namespace griffith {

/// Detected contacts that are replaced, by index, and those that replace them.
struct SpreadContacts {
  std::vector<bool> replaced;
  std::vector<Contact> added;
};

/// Returns contacts that replace the few contacts of proxies: at all nodes where an elastic body lies on the ground, or
/// a face of it on that of another body, so that a face distributes its load over its nodes. Distances are those of the
/// deformed surfaces. Pieces that a crack has just separated are left alone. Pairs that already have such contacts keep
/// them. Nodes that may reach the ground in a substep of `dt` [s] are included.
SpreadContacts spread_contacts(const WorldState& world, double dt);

}  // namespace griffith
