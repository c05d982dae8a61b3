#pragma once

#include <span>
#include <vector>

#include "sim/contact/contact_world.h"
#include "sim/mesh/tet_mesh.h"
#include "sim/world/state/world_state.h"

namespace griffith {

/// Largest number of corners of a convex part of an undivided body. What is round rolls, and meets others where its
/// surface is: that of a ball of 162 corners lies within a fiftieth of its radius.
inline constexpr int kCornersOfUndivided = 162;

/// Returns the convex parts of tets of a mesh (ascending), with its nodes at `positions`, relative to `center` [m], of
/// at most `max_corners` each.
std::vector<ConvexPart> tet_parts(const TetMesh& mesh, std::span<const Vec3> positions, std::span<const TetId> tets,
                                  const Vec3& center, int max_corners);

/// True if a thin body is bent: a node is farther than `distance` [m] from where the shape at rest has it.
bool is_bent_by(const WorldState& world, const Body& body, double distance);

/// Returns the convex parts of the body's present shape, relative to its center of mass: those of its splinters if the
/// scene requests them and they are few enough, else those of its tets.
std::vector<ConvexPart> collision_parts(const WorldState& world, const Body& body);

}  // namespace griffith
