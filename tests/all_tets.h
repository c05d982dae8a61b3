#pragma once

#include <vector>

#include "sim/mesh/tet_mesh.h"

namespace griffith::testing {

inline std::vector<TetId> all_tets(const TetMesh& mesh) {
  std::vector<TetId> tets;
  for (const TetId tet : IdRange<TetId>(0, mesh.tet_count())) tets.push_back(tet);
  return tets;
}

}  // namespace griffith::testing
