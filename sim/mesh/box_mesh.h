#pragma once

#include "sim/mesh/box_pattern.h"
#include "sim/mesh/hex_mesh.h"
#include "sim/mesh/tet_mesh.h"

namespace griffith {

/// Returns a box with edge lengths `size` [m], centered on the origin, of max(1, round(size / element_size)) equal
/// cells along each axis, each cut into tets by `pattern`. All tets are positively oriented and all faces conform.
/// Throws InputError if a length is not positive and finite, or if the box would have more than kMaxCells cells.
TetSoup make_box(const Vec3& size, const Vec3& element_size, BoxPattern pattern);

/// Returns the box before it is cut. Cell (i, j, k) has the index i + cells_x·(j + cells_y·k), nodes likewise.
HexMesh make_box_hexes(const Vec3& size, const std::array<int, 3>& cells);

/// Returns the number of cells of length about `element_size` that fill `length`, at least 1. Throws InputError, naming
/// `what`, unless both are positive and finite, and if there are more than kMaxCells.
int cell_count(double length, double element_size, const char* what);

}  // namespace griffith
