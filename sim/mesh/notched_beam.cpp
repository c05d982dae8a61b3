#include <numeric>
#include <string>

#include "sim/core/error.h"
#include "sim/mesh/box_mesh.h"
#include "sim/mesh/shapes.h"

namespace griffith {
namespace {

/// Moves the rows of nodes so that row `tip_row` of `rows` lies at the tip of the notch.
void place_rows(HexMesh& beam, double height, double notch_depth, int tip_row, int rows, int nodes_per_row) {
  for (std::size_t i = 0; i < beam.points.size(); ++i) {
    const int row = static_cast<int>(i) / nodes_per_row % (rows + 1);
    const double y = row <= tip_row ? notch_depth * row / tip_row
                                    : notch_depth + (height - notch_depth) * (row - tip_row) / (rows - tip_row);
    beam.points[i].y() = y - height / 2;
  }
}

/// Gives the cells on the far side of the slit separate nodes on its face, below the tip.
void open_slit(HexMesh& beam, int middle_column, int tip_row, int rows, int nodes_per_row) {
  std::vector<int> copies(beam.points.size(), -1);
  const int originals = static_cast<int>(beam.points.size());
  const int columns = nodes_per_row - 1;
  beam.originals.resize(originals);
  std::iota(beam.originals.begin(), beam.originals.end(), 0);
  for (std::size_t i = 0; i < beam.cells.size(); ++i) {
    if (static_cast<int>(i) % columns != middle_column) continue;  // cells right of the slit
    for (int& corner : beam.cells[i]) {
      if (corner >= originals || corner % nodes_per_row != middle_column) continue;
      if (corner / nodes_per_row % (rows + 1) >= tip_row) continue;
      if (copies[corner] < 0) {
        copies[corner] = static_cast<int>(beam.points.size());
        beam.points.push_back(Vec3(beam.points[corner]));
        beam.originals.push_back(corner);
      }
      corner = copies[corner];
    }
  }
}

}  // namespace

TetSoup make_notched_beam(const Vec3& size, double notch_depth, const Vec3& element_size, BoxPattern pattern) {
  const int half_columns = cell_count(size.x() / 2, element_size.x(), "beam, half its length");
  const int levels = cell_count(size.z(), element_size.z(), "beam, thickness");
  if (!(notch_depth > 0 && notch_depth < size.y()))
    throw InputError("notched beam", "notch depth " + std::to_string(notch_depth) + " m",
                     "more than 0 and less than the beam's height");
  const int tip_row = cell_count(notch_depth, element_size.y(), "beam, notch depth");
  const int rows = tip_row + cell_count(size.y() - notch_depth, element_size.y(), "beam, height above the notch");
  HexMesh beam = make_box_hexes(size, {2 * half_columns, rows, levels});
  const int nodes_per_row = 2 * half_columns + 1;
  place_rows(beam, size.y(), notch_depth, tip_row, rows, nodes_per_row);
  open_slit(beam, half_columns, tip_row, rows, nodes_per_row);
  return cut_into_tets(beam, pattern);
}

}  // namespace griffith
