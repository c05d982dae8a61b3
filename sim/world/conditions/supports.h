#pragma once

#include "sim/core/error.h"
#include "sim/fracture/split.h"
#include "sim/scene/boundary_condition.h"
#include "sim/world/setup/rest_body.h"

namespace griffith {

struct Scene;
struct WorldState;

/// Support and the nodes that it holds.
struct PlacedSupport {
  Support support;
  std::vector<TetCorner> corners;  ///< all at its nodes: where a crack parts one, it holds both, until it tears
  bool holds_faces = false;        ///< true if it held faces of elements when it was placed
};

/// Finds the nodes of a body's supports, once, and appends these; one that holds none becomes a finding. Then
/// update_supports().
void place_supports(const Scene& scene, int scene_body, const RestBody& body, std::vector<PlacedSupport>& all,
                    std::vector<InputError>& findings);

/// Releases a node from a support along the plane of unit normal `normal` between body and support, if all elements lie
/// on one side of it. Returns false if no support holds the node in that direction, or it cannot tear.
bool tear_off(WorldState& world, NodeId node, const Vec3& normal);
/// Reassigns supports after cracks at held nodes: the pieces that are held best (by an element, a face, an edge, a
/// point) remain held, the others tear off. Returns true if any did.
bool reassign_supports(WorldState& world, std::span<const NodeCopy> copies);

/// Sets the constraints of all held nodes for a substep of `dt` from `time` [s], or for that moment where `dt` is 0.
/// Prescribed supports that stop within the substep move slower, so that they get exactly as far as they should. Which
/// directions are blocked never changes.
void update_supports(WorldState& world, double time, double dt);
/// Takes pieces off supports that hold them by a node or an edge alone: no area bonds them. What a support held by
/// nodes or edges from the start, as a roller does, stays held.
void release_unbonded(WorldState& world, std::span<const BodyId> pieces);

}  // namespace griffith
