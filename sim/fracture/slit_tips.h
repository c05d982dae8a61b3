#pragma once

#include <vector>

#include "sim/mesh/tet_mesh.h"

namespace griffith {

/// The nodes at which slits end, ascending: crack fronts that a mesh has from the start. A slit is where two sides of
/// the surface lie on each other; from its tip two edges lead to the same place, one along either side.
std::vector<NodeId> slit_tips(const TetMesh& mesh);

}  // namespace griffith
