#pragma once

#include <span>
#include <vector>

#include "sim/contact/contact_world.h"
#include "sim/mesh/tet_mesh.h"
#include "sim/world/world_state.h"

namespace griffith {

/// Convex parts of tets of a mesh (ascending), its nodes at `positions`, relative to `center` [m].
std::vector<ConvexPart> tet_parts(const TetMesh& mesh, std::span<const Vec3> positions, std::span<const TetId> tets,
                                  const Vec3& center);

/// Convex parts of the body's present shape, relative to its center of mass: of the splinters that it owns where the
/// scene asks for that and they are not too many to be told from a whole, else of its tets.
std::vector<ConvexPart> collision_parts(const WorldState& world, const Body& body);

}  // namespace griffith
