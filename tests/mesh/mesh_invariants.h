#pragma once

#include <string>
#include <vector>

#include "sim/mesh/tet_mesh.h"

namespace griffith::testing {

/// Returns the violated invariants of a mesh, one sentence each: ids in range, volumes positive, links symmetric and
/// across the same three nodes, equal faces linked, stars exact and ascending, no node without tets, every star
/// connected by faces. Empty if all hold; stops after 20 findings.
std::vector<std::string> check_invariants(const TetMesh& mesh);

}  // namespace griffith::testing
