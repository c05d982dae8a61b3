#pragma once

#include <array>
#include <vector>

#include "sim/mesh/tet_mesh.h"
#include "sim/meshing/triangle_tree.h"

namespace griffith {

/// Point that follows a tet: the weighted sum of its corners. The weights sum to 1; some are negative outside the tet.
struct EmbeddedPoint {
  int tet = -1;
  std::array<double, 4> weights = {};
};

/// Search for the tet at a point: a grid of cells with their tets and, for points outside, a tree of the soup's
/// surface.
class TetLocator {
 public:
  /// `soup`: prepared, not empty; must outlive this object.
  explicit TetLocator(const TetSoup& soup);

  /// Returns the tet that contains the point, or else the one with the nearest face, and the point's weights in it.
  EmbeddedPoint locate(const Vec3& point) const;
  /// Returns the barycentric coordinates of a point in a tet.
  std::array<double, 4> weights_in(int tet, const Vec3& point) const;

 private:
  /// Returns the cell of a point, clamped to the grid.
  std::array<int, 3> cell_of(const Vec3& point) const;
  int flat(const std::array<int, 3>& cell) const { return cell[0] + size_[0] * (cell[1] + size_[1] * cell[2]); }
  template <class Visit>
  void for_each_cell_of(std::size_t tet, const Visit& visit) const;
  void fill_cells();

  const TetSoup& soup_;
  std::vector<int> tet_of_triangle_;  ///< tets of `surface_`, filled while it is built
  TriangleTree surface_;
  Eigen::AlignedBox3d box_;
  std::array<int, 3> size_;
  Vec3 cell_;                      ///< edges of a cell [m]
  std::vector<int> first_, tets_;  ///< per cell: start of its tets; tets of all cells
};

}  // namespace griffith
