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
  const double middle = beam.points[half_columns].x(), tip = beam.points[tip_row * nodes_per_row].y();
  open_slit(beam, Vec3::UnitX(), [&](const Vec3& point) { return point.x() == middle && point.y() < tip; });
  return cut_into_tets(beam, pattern);
}

}  // namespace griffith
