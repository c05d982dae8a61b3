#pragma once

#include <array>
#include <map>
#include <vector>

#include "sim/core/linear_algebra.h"
#include "sim/mesh/box_pattern.h"
#include "sim/mesh/tet_mesh.h"

namespace griffith {

/// No generator makes more cells than this: a slip in an element size should not fill the memory.
inline constexpr int kMaxCells = 20'000'000;

/// Hexahedra as generated. Corner c of a cell lies at its local coordinates (c & 1, c >> 1 & 1, c >> 2), a right-handed
/// frame. Cells meet in whole faces.
struct HexMesh {
  std::vector<Vec3> points;               ///< [m]
  std::vector<std::array<int, 8>> cells;  ///< indices into `points`
};

/// Cuts every cell into tets whose faces conform, also where cells meet at odd angles: every diagonal is chosen by the
/// nodes alone. `kuhn`: 6 tets that share the cell's smallest node, each face split through its smallest node (after
/// Dompierre et al. 1999). `five_tet`: the nodes are coloured alternately along the edges, each cell's inner tet has
/// the corners of one colour; an edge cycle of odd length is a programmer's mistake. `bcc`: a node in the middle of
/// each cell, 4 tets round each inner face, 2 on each outer one.
TetSoup cut_into_tets(const HexMesh& hexes, BoxPattern pattern);

/// Builds hexahedra from mapped blocks. A node is known by four integers of the caller's choosing, so blocks that name
/// their common nodes alike share them.
class HexMeshBuilder {
 public:
  using Key = std::array<int, 4>;

  /// The node's index; `position` counts the first time.
  int node(const Key& key, const Vec3& position);
  /// Adds a cell with its corners in HexMesh's order; a left-handed cell is mirrored.
  void add_cell(std::array<int, 8> corners);
  HexMesh take() { return std::move(mesh_); }

 private:
  std::map<Key, int> nodes_;
  HexMesh mesh_;
};

}  // namespace griffith
