#pragma once

#include <functional>
#include <span>
#include <vector>

#include "sim/fracture/cohesion.h"
#include "sim/world/state/world_state.h"

namespace griffith {

/// Bond of a corner of an opened face.
struct NewBond {
  OpenFace face;
  int corner = 0;  ///< 0..2, of `face`
  Bond bond;       ///< for full stiffness, unless the accelerations are those of a scaled body
};

/// A node that has come apart, and what acted on it then.
struct PartedNode {
  NodeId original;
  std::span<const NodeId> copies;  ///< made of it, without itself
  double utilization = 1;          ///< > 0; a node that was overloaded is bonded at the critical stress
  double similarity = 1;           ///< f of its body (similarity.h), 0..1
  Mat3 turn = Mat3::Identity();    ///< from the place at rest to the present one
};

/// Returns the bonds between the copies of a node, across the faces between them: at the stress that they carry, or
/// that they could carry if it exceeds that. None where force decides. `acceleration`: that of a copy by the forces on
/// it alone [m/s²].
std::vector<NewBond> bonds_between(const WorldState& world, const PartedNode& parted,
                                   const std::function<Vec3(NodeId)>& acceleration);

/// Bonds the copies of a node that has come apart in a step without microsteps, loaded `utilization` times its
/// resistance: by the forces of its elements, whose states are those before.
void bond_copies(WorldState& world, NodeId original, std::span<const NodeId> copies, double utilization);

}  // namespace griffith
