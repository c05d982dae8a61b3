#pragma once

#include <map>
#include <optional>

#include "sim/mesh/bisect.h"
#include "sim/solver/rigid_motion.h"

namespace griffith {

struct Body;
struct WorldState;

/// Sets the values of bisected parts: nodes get those interpolated along their edges, tets those of the original tets.
/// A new node is held if a support holds both ends of its edge. A load on a face or tet acts on both halves; other
/// places stay with their nodes. Of the bodies, only the lists of tets are updated.
void follow_subdivision(WorldState& world, const Subdivision& subdivision);

/// Motions of bodies before they were remeshed; none of those that were held.
using MotionsBefore = std::map<BodyId, std::optional<RigidMotion>>;

/// Records a body's motion before the first of its cracks, when no copies of nodes exist yet.
void record_motion(const WorldState& world, const Body& body, MotionsBefore& motions);

/// Restores the angular momentum `before` of a body, whose nodes and edges are known, by a rotation as a whole; of a
/// quadratic one also its momentum.
void restore_momenta(WorldState& world, const Body& body, const RigidMotion& before);

/// Restores the momenta that interpolation changed, by a motion as a whole, which does not change the shape.
void restore_momenta(WorldState& world, const MotionsBefore& motions);

}  // namespace griffith
