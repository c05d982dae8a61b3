#pragma once

namespace griffith {

/// How a box cell is cut into tetrahedra.
enum class BoxPattern {
  kuhn,      ///< 6 tets round the cell's diagonal, the same way in every cell
  five_tet,  ///< 5 tets, mirrored from cell to cell: softer in bending, no preferred diagonal
  bcc,       ///< body-centred cubic: a node in each cell's middle
};

}  // namespace griffith
