#pragma once

#include <span>
#include <vector>

#include "sim/contact/contact_world.h"
#include "sim/mesh/tet_mesh.h"

namespace griffith {

/// Convex parts of tets of a mesh (ascending), its nodes at `positions`, relative to `center` [m].
std::vector<ConvexPart> tet_parts(const TetMesh& mesh, std::span<const Vec3> positions, std::span<const TetId> tets,
                                  const Vec3& center);

}  // namespace griffith
