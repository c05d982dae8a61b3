#pragma once

#include <vector>

#include "sim/mesh/tet_mesh.h"

namespace griffith {

/// Returns the nodes at the ends of slits, ascending: initial crack fronts of a mesh. Two sides of the surface coincide
/// at a slit. From its tip two edges lead to the same place, one along either side.
std::vector<NodeId> slit_tips(const TetMesh& mesh);

}  // namespace griffith
