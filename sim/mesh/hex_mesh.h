#pragma once

#include <array>
#include <functional>
#include <map>
#include <vector>

#include "sim/core/linear_algebra.h"
#include "sim/mesh/box_pattern.h"
#include "sim/mesh/tet_mesh.h"

namespace griffith {

/// Largest number of cells of any generator, so that a typo in an element size does not fill the memory.
inline constexpr int kMaxCells = 20'000'000;

/// Hexahedra as generated. Corner c of a cell has the local coordinates (c & 1, c >> 1 & 1, c >> 2) in a right-handed
/// frame. Cells meet in whole faces.
struct HexMesh {
  std::vector<Vec3> points;               ///< [m]
  std::vector<std::array<int, 8>> cells;  ///< indices into `points`
  std::vector<int> originals;             ///< per point of a slit: that of its first side; empty without slits

  /// Returns the node by which diagonals are chosen, the same on both sides of a slit.
  int original(int node) const { return originals.empty() ? node : originals[node]; }
};

/// Cuts every cell into tets with conforming faces, also where cells meet at odd angles, since nodes alone determine
/// every diagonal. `kuhn`: 6 tets that share the cell's smallest node, each face split through its smallest node (after
/// Dompierre et al. 1999). `five_tet`: nodes are colored alternately along the edges, and the inner tet of a cell has
/// corners of one color; an edge cycle of odd length is a programming error. `bcc`: a node in the center of each cell,
/// 4 tets around each inner face, 2 on each outer one.
TetSoup cut_into_tets(const HexMesh& hexes, BoxPattern pattern);

/// Opens a slit: nodes for which `inside` holds get copies, used by the cells on the side of `normal`. Both sides keep
/// the same diagonals.
void open_slit(HexMesh& mesh, const Vec3& normal, const std::function<bool(const Vec3& point)>& inside);

/// Builder of hexahedra from mapped blocks. Four integers chosen by the caller identify a node, so blocks share nodes
/// of the same integers.
class HexMeshBuilder {
 public:
  using Key = std::array<int, 4>;

  /// Returns the node's index. Only the first call with a key uses `position`.
  int node(const Key& key, const Vec3& position);
  /// Adds a cell with corners in the order of HexMesh. A left-handed cell is mirrored.
  void add_cell(std::array<int, 8> corners);
  HexMesh take() { return std::move(mesh_); }

 private:
  std::map<Key, int> nodes_;
  HexMesh mesh_;
};

}  // namespace griffith
