#pragma once

#include <vector>

#include "sim/fracture/cohesion.h"
#include "sim/world/state/world_state.h"

namespace griffith {

/// Two nodes, coincident at rest, and the bonds between them.
struct BondedPair {
  /// A bond among those of the world.
  struct Part {
    int face = 0;    ///< index into WorldState::cohesive_faces
    int corner = 0;  ///< 0..2
    bool operator==(const Part&) const = default;
  };
  NodeId first, second;
  std::vector<Part> parts;
  std::vector<Bond> bonds;  ///< bonds of the parts
  double opening = 0;       ///< largest so far [m]

  /// Returns the force that takes the energy of their law if it is constant up to an opening `now` [m] [N].
  double force_up_to(double now) const;
};

/// Copies of an edge of quadratic tets along a crack that move as one.
struct TiedEdges {
  EdgeId first, second;
  auto operator<=>(const TiedEdges&) const = default;
};

/// Bonds of a body that deforms, in the order of their nodes.
struct BondsOfBody {
  BodyId body;
  std::vector<BondedPair> pairs;
  std::vector<TiedEdges> ties;
};

/// True if bonds act in steps without microsteps. In hybrid steps they act in microsteps alone: what breaks there has
/// so many of them, and is so soon at rest, that they would cost more than all else (part_at_bonds.h).
bool bonds_act(const WorldState& world);
/// Returns the bonds that act in a step without microsteps, by body.
std::vector<BondsOfBody> acting_bonds(const WorldState& world);
/// Marks the bodies in which bonds act, per BodyId.
std::vector<bool> bodies_with_bonds(const WorldState& world);

/// Returns what bonds do per node, empty without any: those bear a traction that are as far open as they have ever
/// been.
std::vector<HeldNode> held_nodes(const WorldState& world);

/// Opens bonds as far as a step without microsteps has moved their nodes apart. The energy that they take counts as
/// that of fracture in place of contacts, with which they were solved. Adds the bodies in which bonds broke to
/// Scratch::bonds_broke_in.
void open_bonds(WorldState& world);

}  // namespace griffith
