#include "sim/mesh/box_mesh.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>

#include "sim/core/error.h"

namespace griffith {
namespace {

std::array<int, 8> corners_of_cell(int i, int j, int k, const std::array<int, 3>& cells) {
  std::array<int, 8> corners;
  for (int c = 0; c < 8; ++c) {
    const int x = i + (c & 1), y = j + (c >> 1 & 1), z = k + (c >> 2);
    corners[c] = x + (cells[0] + 1) * (y + (cells[1] + 1) * z);
  }
  return corners;
}

void check_total(const std::array<int, 3>& cells) {
  const double total = double(cells[0]) * cells[1] * cells[2];
  if (total > kMaxCells) {
    throw InputError("box", "the element size asks for " + std::to_string(std::int64_t(total)) + " cells",
                     "at most " + std::to_string(kMaxCells) + "; make the elements larger");
  }
}

}  // namespace

int cell_count(double length, double element_size, const char* what) {
  if (!(length > 0 && std::isfinite(length))) {
    throw InputError(what, "length " + std::to_string(length) + " m", "lengths are positive and finite");
  }
  if (!(element_size > 0 && std::isfinite(element_size))) {
    throw InputError(what, "element size " + std::to_string(element_size) + " m", "sizes are positive and finite");
  }
  const double count = std::max(1.0, std::round(length / element_size));
  if (count > kMaxCells) {
    throw InputError(what, "the element size is too small for the length", "make the elements larger");
  }
  return static_cast<int>(count);
}

HexMesh make_box_hexes(const Vec3& size, const std::array<int, 3>& cells) {
  check_total(cells);
  const Vec3 cell_size = size.cwiseQuotient(Vec3(cells[0], cells[1], cells[2]));
  HexMesh box;
  for (int k = 0; k <= cells[2]; ++k)
    for (int j = 0; j <= cells[1]; ++j)
      for (int i = 0; i <= cells[0]; ++i) {
        // Measured from the middle, so that opposite sides are exact mirror images.
        const Vec3 half_steps(2 * i - cells[0], 2 * j - cells[1], 2 * k - cells[2]);
        box.points.push_back(0.5 * half_steps.cwiseProduct(cell_size));
      }
  for (int k = 0; k < cells[2]; ++k)
    for (int j = 0; j < cells[1]; ++j)
      for (int i = 0; i < cells[0]; ++i) box.cells.push_back(corners_of_cell(i, j, k, cells));
  return box;
}

TetSoup make_box(const Vec3& size, const Vec3& element_size, BoxPattern pattern) {
  const std::array<int, 3> cells = {cell_count(size.x(), element_size.x(), "box, x"),
                                    cell_count(size.y(), element_size.y(), "box, y"),
                                    cell_count(size.z(), element_size.z(), "box, z")};
  return cut_into_tets(make_box_hexes(size, cells), pattern);
}

}  // namespace griffith
