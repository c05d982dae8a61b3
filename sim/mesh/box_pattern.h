#pragma once

namespace griffith {

/// Division of a box cell into tetrahedra.
enum class BoxPattern {
  kuhn,      ///< 6 tets around the cell's diagonal, with the same orientation in every cell
  five_tet,  ///< 5 tets, mirrored from cell to cell: softer in bending, without a preferred diagonal
  bcc,       ///< body-centered cubic, with a node in the center of each cell
};

}  // namespace griffith
