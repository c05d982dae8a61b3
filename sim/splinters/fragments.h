#pragma once

#include <vector>

#include "sim/core/monitor.h"
#include "sim/mesh/tet_mesh.h"
#include "sim/splinters/convex_polyhedron.h"

namespace griffith {

/// Intersection of a cell and a tet.
struct Fragment {
  TetId tet;
  int cell = 0;
  ConvexPolyhedron polyhedron;
  double volume = 0;  ///< [m³]
};

/// Divides every tet of a mesh in rest space among the cells. The fragments of a tet fill it without overlap. Ordered
/// by tet, then cell. Throws Cancelled when the monitor cancels.
std::vector<Fragment> make_fragments(const TetMesh& mesh, const CellPartition& cells, const Monitor& monitor = {});

}  // namespace griffith
