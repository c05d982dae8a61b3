#pragma once

#include <array>
#include <string>

#include "sim/core/linear_algebra.h"

namespace griffith {

/// Body-centered cubic lattice: the corners and centers of a block of cubes. Its tets have two opposite long edges, as
/// long as a cube's edge, and four short ones of √3/2 that length.
class BccLattice {
 public:
  using Index3 = std::array<int, 3>;

  /// Covers `box` and at least one more cube on each side. Throws InputError, about `name`, if that takes more than
  /// kMostCells cubes.
  BccLattice(const Eigen::AlignedBox3d& box, double cube_edge, const std::string& name);

  static constexpr double kMaxCells = 1e7;

  int vertex_count() const { return corner_count_ + middle_count_; }
  double cube_edge() const { return edge_; }
  Index3 cells() const { return cells_; }

  /// Returns coordinates in half edges: even ones at corners, odd ones at centers.
  Index3 coordinates(int vertex) const;
  /// Returns the vertex there; -1 outside the lattice. The coordinates must be all even or all odd.
  int vertex(const Index3& coordinates) const;
  Vec3 position(int vertex) const;

  /// True if two neighboring vertices are a long edge apart.
  bool is_long(int a, int b) const { return (a < corner_count_) == (b < corner_count_); }

  /// Returns the steps to the 14 neighbors of a vertex: 6 along long edges, 8 along short ones.
  static const std::array<Index3, 14>& steps();

  /// Returns the tets around the face between a cube and the next one along `axis`; ids of -1 if the next one is
  /// outside.
  std::array<std::array<int, 4>, 4> tets_at(const Index3& cell, int axis) const;

 private:
  Vec3 origin_;
  double edge_;
  Index3 cells_;
  int corner_count_, middle_count_;
};

}  // namespace griffith
