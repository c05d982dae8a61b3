#pragma once

#include <map>
#include <span>

#include "sim/mesh/bisect.h"
#include "sim/solver/rigid_motion.h"

namespace griffith {

struct WorldState;

/// Gives what bisections made its values: nodes those interpolated along their edges, tets those of the tets that they
/// come from. Supports are not known to the new nodes before follow_bisections().
void follow_subdivision(WorldState& world, const Subdivision& subdivision);

/// Lets supports, loads and probes go on with the halves of the bisected tets, in the bisections'
/// order. A new node is held where both ends of its edge are; a load on a face or tet acts on both halves; the rest
/// stays with its nodes.
void follow_bisections(WorldState& world, std::span<const TetBisection> bisections);

/// Motions of free bodies before they were remeshed.
using MotionsBefore = std::map<BodyId, RigidMotion>;

/// Gives bodies back the angular momentum that interpolation took, by a rotation as a whole: it alone does not change
/// their shape.
void restore_angular_momentum(WorldState& world, const MotionsBefore& before);

}  // namespace griffith
