#include "sim/mesh/bisect.h"

#include <algorithm>
#include <cassert>

#include "sim/mesh/mesh_report.h"
#include "sim/mesh/topology.h"

namespace griffith {
namespace {

/// Links the halves of a piece's tets with each other and with the tets behind them. The child of piece[i] is tet
/// `first_child` + i.
void link_children(TetMesh& mesh, const std::vector<TetId>& piece, const std::vector<TetBisection>& halves) {
  const auto child_of = [&](TetId tet) {
    return halves[std::lower_bound(piece.begin(), piece.end(), tet) - piece.begin()].child;
  };
  for (const auto& [tet, child, kept, moved, middle] : halves) {
    const TetId behind = mesh.neighbors[tet][kept];
    auto& links = mesh.neighbors[child] = mesh.neighbors[tet];
    for (int face = 0; face < 4; ++face)
      if (face != kept && face != moved && links[face].valid()) links[face] = child_of(links[face]);
    links[moved] = tet;
    mesh.neighbors[tet][kept] = child;
    if (behind.valid()) mesh.neighbors[behind][face_toward(mesh, behind, tet)] = child;
  }
}

/// Removes the bisected tets from the star of `b`, and adds their children to the stars of their corners.
void update_stars(TetMesh& mesh, const std::vector<TetId>& piece, const std::vector<TetBisection>& halves, NodeId b,
                  NodeId middle) {
  std::erase_if(mesh.stars[b], [&](TetId tet) { return std::binary_search(piece.begin(), piece.end(), tet); });
  mesh.stars[middle] = piece;
  for (const TetBisection& half : halves)
    for (NodeId corner : mesh.tets[half.child]) mesh.stars[corner].push_back(half.child);
}

void bisect_piece(TetMesh& mesh, const std::vector<TetId>& piece, NodeId a, NodeId b, double weight, Subdivision& log) {
  const EdgeNode middle{NodeId(mesh.node_count()), a, b, weight};
  mesh.rest_positions.push_back(middle.interpolate(mesh.rest_positions[a], mesh.rest_positions[b]));
  mesh.stars.emplace_back();
  std::vector<TetBisection> halves;
  for (TetId tet : piece) {
    halves.push_back(
        {tet, TetId(mesh.tet_count()), local_corner(mesh, tet, a), local_corner(mesh, tet, b), middle.node});
    mesh.tets.push_back(std::array<NodeId, 4>(mesh.tets[tet]));
    mesh.tets.back()[halves.back().kept] = middle.node;
    mesh.tets[tet][halves.back().moved] = middle.node;
  }
  mesh.neighbors.resize(mesh.tets.size());
  link_children(mesh, piece, halves);
  update_stars(mesh, piece, halves, b, middle.node);
  log.nodes.push_back(middle);
  log.tets.insert(log.tets.end(), halves.begin(), halves.end());
}

/// Returns the quality of a tet with one corner moved.
double quality_with(const TetMesh& mesh, TetId tet, int corner, const Vec3& place) {
  std::array<Vec3, 4> points;
  for (int i = 0; i < 4; ++i) points[i] = i == corner ? place : mesh.rest_positions[mesh.tets[tet][i]];
  return tet_quality(points[0], points[1], points[2], points[3]);
}

}  // namespace

bool can_bisect(const TetMesh& mesh, NodeId a, NodeId b, double weight, const BisectionLimits& limits) {
  const EdgeNode middle{NodeId(), a, b, weight};
  const Vec3 place = middle.interpolate(mesh.rest_positions[a], mesh.rest_positions[b]);
  for (const std::vector<TetId>& piece : edge_components(mesh, a, b))
    for (TetId tet : piece) {
      for (NodeId corner : mesh.tets[tet])
        if ((mesh.rest_positions[corner] - place).norm() < limits.min_length) return false;
      for (NodeId end : {a, b})
        if (quality_with(mesh, tet, local_corner(mesh, tet, end), place) < limits.min_quality) return false;
    }
  return true;
}

void bisect_edge(TetMesh& mesh, NodeId a, NodeId b, double weight, Subdivision& log) {
  assert(weight > 0 && weight < 1);
  const std::vector<std::vector<TetId>> pieces = edge_components(mesh, a, b);
  assert(!pieces.empty());
  for (const std::vector<TetId>& piece : pieces) bisect_piece(mesh, piece, a, b, weight, log);
}

}  // namespace griffith
