#pragma once

#include <vector>

#include "sim/mesh/tet_mesh.h"
#include "sim/mesh/topology.h"
#include "sim/scene/region.h"

namespace griffith {

/// Corner `corner` of `tet`. It permanently marks the same piece of material, while a node may be split into several;
/// follow_subdivision() (subdivision.h) updates it when tets are bisected.
struct TetCorner {
  TetId tet;
  int corner = 0;
};

/// Returns the present node at a corner. `tets`: per tet, its corners.
inline NodeId node_at(std::span<const std::array<NodeId, 4>> tets, const TetCorner& place) {
  return tets[place.tet][place.corner];
}

/// Scene body in its rest space, unbroken, in which its regions are evaluated.
struct RestBody {
  const TetSoup& soup;                    ///< prepared
  const std::vector<int>& point_of_node;  ///< per node of the soup: the point as read that it was
  const TetMesh& mesh;                    ///< mesh of the soup
  AppendedRange range;                    ///< range of its nodes and tets in the world's mesh
};

/// Returns, per node of the body, 1 if it is in the region, including its boundary. Regions refer to nodes by their
/// number as read.
std::vector<std::uint8_t> nodes_in(const RestBody& body, const Region& region);

/// Returns the number of the soup's node at a corner.
int soup_node(const RestBody& body, const TetCorner& corner);

/// Returns all corners of all tets at the nodes marked with 1.
std::vector<TetCorner> corners_at(const RestBody& body, const std::vector<std::uint8_t>& marked);

}  // namespace griffith
