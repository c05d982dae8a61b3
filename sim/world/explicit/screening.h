#pragma once

#include "sim/mesh/tet_mesh.h"

namespace griffith {

struct WorldState;

/// Returns the largest principal stress of the elements at a node up to which the node cannot be overloaded, under the
/// full stiffness [Pa]; infinite if it cannot separate.
///   at_front  true: by stress or by the energy release rate of a crack front; false: by stress alone
float screening_stress(const WorldState& world, NodeId node, bool at_front);

}  // namespace griffith
