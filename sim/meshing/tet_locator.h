#pragma once

#include <vector>

#include "sim/mesh/tet_mesh.h"
#include "sim/meshing/embedding.h"
#include "sim/meshing/triangle_tree.h"

namespace griffith {

/// Finds the tet at a point, by a grid of cells that know their tets and, outside, by a tree of the soup's surface.
class TetLocator {
 public:
  /// `soup`: prepared, not empty; it has to live as long as this.
  explicit TetLocator(const TetSoup& soup);

  /// The tet that holds the point, or else the one whose face is nearest, with the point's weights in it.
  EmbeddedPoint locate(const Vec3& point) const;
  /// The weights of a point in a tet (barycentric coordinates).
  std::array<double, 4> weights_in(int tet, const Vec3& point) const;

 private:
  /// The cell, clamped to the grid, that holds a point.
  std::array<int, 3> cell_of(const Vec3& point) const;
  int flat(const std::array<int, 3>& cell) const { return cell[0] + size_[0] * (cell[1] + size_[1] * cell[2]); }
  template <class Visit>
  void for_each_cell_of(std::size_t tet, const Visit& visit) const;
  void fill_cells();

  const TetSoup& soup_;
  std::vector<int> tet_of_triangle_;  ///< of `surface_`; filled as that is made
  TriangleTree surface_;
  Eigen::AlignedBox3d box_;
  std::array<int, 3> size_;
  Vec3 cell_;                      ///< edges [m]
  std::vector<int> first_, tets_;  ///< per cell, where its tets begin; the tets of all cells
};

}  // namespace griffith
