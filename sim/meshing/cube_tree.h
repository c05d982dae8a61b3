#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "sim/meshing/bcc_lattice.h"

namespace griffith {

/// Cubes of a body-centered lattice, merged in groups of eight, up to a number of levels, where only deep vertices are
/// near. Cubes that touch differ by at most one level, and all vertices belong to the lattice (Labelle & Shewchuk 2007,
/// section 4).
class CubeTree {
 public:
  /// `is_deep`: true if a vertex may belong to a larger cube. A cube of level k is 2^k lattice cubes wide.
  CubeTree(const BccLattice& lattice, const std::function<bool(int vertex)>& is_deep, int levels);

  using Visit = std::function<void(const std::array<int, 4>& tet)>;
  /// Calls `visit` for each tet between the centers of two cubes that share a face and the border of that face. Tets of
  /// cubes of level 0 are those of BccLattice::tets_at(); others have dihedral angles from 30° to 135°. Orientations
  /// differ.
  void visit_tets(const Visit& visit) const;

 private:
  using Index3 = BccLattice::Index3;

  void find_deep_cubes(const std::function<bool(int vertex)>& is_deep);
  void merge(int level);
  bool surroundings_reach(const Index3& origin, int width, int level) const;
  bool contains(const Index3& cell) const;
  std::size_t index(const Index3& cell) const;
  /// Returns the level of the cube that contains a lattice cube; 0 outside the lattice.
  int level(const Index3& cell) const;
  void visit_face(const Index3& origin, int axis, int side, const Visit& visit) const;
  std::vector<int> outline(const Index3& middle, int axis, int level) const;
  bool touches_smaller(const Index3& place, int level) const;

  const BccLattice& lattice_;
  std::vector<std::int8_t> levels_;  ///< level of each lattice cube; -1: has vertices that are not deep
};

}  // namespace griffith
