#pragma once

#include <vector>

#include "sim/world/state/world_state.h"

namespace griffith {

/// Detected contacts that are replaced, by index, and those that replace them.
struct SpreadContacts {
  std::vector<bool> replaced;
  std::vector<Contact> added;
};

/// Contacts where a face of a body lies on another object, and the nodes there, as contacts without impulses.
struct FacePatch {
  std::vector<int> contacts;  ///< indices, ascending
  std::vector<Contact> nodes;
};

/// Returns the patches of quasi-static bodies, which touch as rigid ones at few contacts.
std::vector<FacePatch> rigid_patches(const WorldState& world);

/// Returns contacts that replace the few contacts of proxies: at all nodes where an deforming body lies on the ground,
/// or a face of it on that of another body, so that a face distributes its load over its nodes. Distances are those of
/// the deformed surfaces. Pieces that a crack has just separated are left alone. Pairs that already have such contacts
/// keep them. Nodes that may reach the ground in a substep of `dt` [s] are included.
SpreadContacts spread_contacts(const WorldState& world, double dt);

}  // namespace griffith
