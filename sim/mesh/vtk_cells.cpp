#include "sim/mesh/vtk_cells.h"

namespace griffith {
namespace {

/// VTK_TETRA, VTK_QUADRATIC_TETRA, VTK_LAGRANGE_TETRAHEDRON, VTK_BEZIER_TETRAHEDRON: all begin with their corners.
bool is_tet(std::int64_t type) { return type == 10 || type == 24 || type == 71 || type == 78; }

}  // namespace

std::string add_vtk_cells(const VtkCells& cells, int first_point, std::int64_t point_count, MeshFile& file) {
  if (cells.types.size() != cells.offsets.size())
    return std::to_string(cells.types.size()) + " cell types for " + std::to_string(cells.offsets.size()) + " cells";
  std::int64_t begin = 0;
  for (std::size_t i = 0; i < cells.types.size(); ++i) {
    const std::int64_t end = cells.offsets[i];
    const std::string cell = "cell " + std::to_string(i);
    if (end < begin || end > static_cast<std::int64_t>(cells.connectivity.size())) return cell + " has a wrong offset";
    if (is_tet(cells.types[i])) {
      if (end - begin < 4) return cell + " is a tetrahedron of " + std::to_string(end - begin) + " points";
      std::array<int, 4> tet;
      for (int corner = 0; corner < 4; ++corner) {
        const std::int64_t point = cells.connectivity[begin + corner];
        if (point < 0 || point >= point_count)
          return cell + " names point " + std::to_string(point) + " of " + std::to_string(point_count);
        tet[corner] = first_point + static_cast<int>(point);
      }
      file.soup.tets.push_back(tet);
    } else {
      ++file.skipped_elements;
    }
    begin = end;
  }
  return {};
}

}  // namespace griffith
