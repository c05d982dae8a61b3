#pragma once

#include <array>
#include <string>

#include "sim/core/linear_algebra.h"

namespace griffith {

/// A body-centred cubic lattice: the corners and the middles of a block of cubes. Its tets have two opposite long
/// edges, of the cube's edge, and four short ones, √3/2 as long.
class BccLattice {
 public:
  using Index3 = std::array<int, 3>;

  /// Covers `box` and at least one cube more on each side. Throws InputError, about `name`, when that takes more than
  /// kMostCells cubes.
  BccLattice(const Eigen::AlignedBox3d& box, double cube_edge, const std::string& name);

  static constexpr double kMaxCells = 1e7;

  int vertex_count() const { return corner_count_ + middle_count_; }
  double cube_edge() const { return edge_; }
  Index3 cells() const { return cells_; }

  /// Coordinates in half edges: even ones at corners, odd ones at middles.
  Index3 coordinates(int vertex) const;
  /// The vertex there; -1 outside of the lattice. The coordinates have to be all even or all odd.
  int vertex(const Index3& coordinates) const;
  Vec3 position(int vertex) const;

  /// Whether two neighbouring vertices are a long edge apart.
  bool is_long(int a, int b) const { return (a < corner_count_) == (b < corner_count_); }

  /// The steps to the 14 neighbours of a vertex: 6 along long edges, 8 along short ones.
  static const std::array<Index3, 14>& steps();

  /// The tets round the face between a cube and the next one along `axis`; ids of -1 where the next is outside.
  std::array<std::array<int, 4>, 4> tets_at(const Index3& cell, int axis) const;

 private:
  Vec3 origin_;
  double edge_;
  Index3 cells_;
  int corner_count_, middle_count_;
};

}  // namespace griffith
