#pragma once

#include <vector>

#include "sim/core/monitor.h"
#include "sim/mesh/tet_mesh.h"
#include "sim/splinters/convex_polyhedron.h"

namespace griffith {

/// What a cell and a tet have in common.
struct Fragment {
  TetId tet;
  int cell = 0;
  ConvexPolyhedron polyhedron;
  double volume = 0;  ///< [m³]
};

/// Parts every tet of a mesh in rest space between the cells: the fragments of a tet fill it without overlap. By tet,
/// then cell. Throws Cancelled when the monitor says so.
std::vector<Fragment> make_fragments(const TetMesh& mesh, const CellPartition& cells, const Monitor& monitor = {});

}  // namespace griffith
