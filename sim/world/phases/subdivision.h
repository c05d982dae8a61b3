#pragma once

#include <map>
#include <optional>

#include "sim/mesh/bisect.h"
#include "sim/solver/rigid_motion.h"

namespace griffith {

struct Body;
struct WorldState;

/// Gives what bisections made its values: nodes those interpolated along their edges, tets those of the tets that they
/// come from. A new node is held where a support has both ends of its edge, a load on a face or tet acts on both
/// halves, and other places stay with their nodes. The bodies' tets are brought up to date, but for nothing else of
/// theirs.
void follow_subdivision(WorldState& world, const Subdivision& subdivision);

/// Motions of bodies before they were remeshed; none of those that were held.
using MotionsBefore = std::map<BodyId, std::optional<RigidMotion>>;

/// Notes a body's motion before the first of its cracks; later ones find it noted, their copies of nodes unknown yet.
void record_motion(const WorldState& world, const Body& body, MotionsBefore& motions);

/// Gives a body, whose nodes are known, back the angular momentum of `before`, by a rotation as a whole.
void restore_angular_momentum(WorldState& world, const Body& body, const RigidMotion& before);

/// Gives bodies back the angular momentum that interpolation took, by a rotation as a whole: it alone does not change
/// their shape.
void restore_angular_momentum(WorldState& world, const MotionsBefore& motions);

}  // namespace griffith
