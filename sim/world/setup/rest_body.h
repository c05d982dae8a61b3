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

/// The node at a corner now. `tets`: per tet, its corners.
inline NodeId node_at(std::span<const std::array<NodeId, 4>> tets, const TetCorner& place) {
  return tets[place.tet][place.corner];
}

/// A scene body in its rest space, before anything has broken, for its regions to be looked up in.
struct RestBody {
  const TetSoup& soup;                    ///< prepared
  const std::vector<int>& point_of_node;  ///< per node of the soup: the point as read that it was
  const TetMesh& mesh;                    ///< mesh of the soup
  AppendedRange range;                    ///< where its nodes and tets are in the world's mesh
};

/// Per node of the body: 1 where it lies in the region, borders included. Regions name nodes by their number as read.
std::vector<std::uint8_t> nodes_in(const RestBody& body, const Region& region);

/// The node of the soup at a corner as the world numbers it.
int soup_node(const RestBody& body, const TetCorner& corner);

/// All corners of all tets at the nodes marked with 1.
std::vector<TetCorner> corners_at(const RestBody& body, const std::vector<std::uint8_t>& marked);

}  // namespace griffith
