#include "sim/fracture/remesh.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "sim/mesh/topology.h"

namespace griffith {
namespace {

/// Nodes around the separating one with their sides of its plane.
class PlaneSides {
 public:
  PlaneSides(const TetMesh& mesh, std::span<const Vec3> positions, NodeId node, const Vec3& normal) {
    for (TetId tet : mesh.stars[node])
      for (NodeId corner : mesh.tets[tet]) heights_[corner] = {normal.dot(positions[corner] - positions[node]), false};
  }
  void snap(NodeId node) { heights_.at(node).snapped = true; }
  /// Returns the height above the plane [m]; 0 for nodes on it and for new ones.
  double height(NodeId node) const {
    const auto found = heights_.find(node);
    return found == heights_.end() || found->second.snapped ? 0 : found->second.height;
  }
  bool crosses(NodeId a, NodeId b) const { return height(a) * height(b) < 0; }
  /// Returns 1 for tets above and 0 for tets below the plane, from their corners off the plane; from all corners if
  /// none is off. If one side is empty then, all corners of all tets count.
  std::vector<std::uint8_t> tets_above(const TetMesh& mesh, const std::vector<TetId>& tets) const {
    std::vector<std::uint8_t> by_snapped, by_all;
    for (TetId tet : tets) {
      double snapped = 0, all = 0;
      for (NodeId corner : mesh.tets[tet]) {
        snapped += height(corner);
        if (const auto found = heights_.find(corner); found != heights_.end()) all += found->second.height;
      }
      by_all.push_back(all > 0);
      by_snapped.push_back(snapped != 0 ? snapped > 0 : all > 0);
    }
    const auto above = std::ranges::count(by_snapped, 1);
    return above > 0 && above < std::ssize(by_snapped) ? by_snapped : by_all;
  }

 private:
  struct Height {
    double height;
    bool snapped;
  };
  std::map<NodeId, Height> heights_;
};

/// Edge across the plane, cut at (1 − weight) a + weight b.
struct CrossedEdge {
  NodeId a, b;
  double weight, length;
  double fraction() const { return std::min(weight, 1 - weight); }
  NodeId nearer_end() const { return weight < 0.5 ? a : b; }
};

std::vector<CrossedEdge> crossed_edges(const TetMesh& mesh, const PlaneSides& sides, NodeId node) {
  std::set<std::pair<NodeId, NodeId>> pairs;
  for (TetId tet : mesh.stars[node])
    for (NodeId a : mesh.tets[tet])
      for (NodeId b : mesh.tets[tet])
        if (a < b && sides.crosses(a, b)) pairs.insert({a, b});
  std::vector<CrossedEdge> edges;
  for (const auto& [a, b] : pairs) {
    const double weight = sides.height(a) / (sides.height(a) - sides.height(b));
    edges.push_back({a, b, weight, (mesh.rest_positions[a] - mesh.rest_positions[b]).norm()});
  }
  return edges;
}

/// Snaps nodes at a small angle to the plane, seen from the separating node. The angle is larger for nodes of a crack
/// front.
void snap_near_nodes(const TetMesh& mesh, std::span<const Vec3> positions, std::span<const std::uint8_t> at_crack_front,
                     NodeId node, const RemeshOptions& options, PlaneSides& sides) {
  for (NodeId other : nodes_of(mesh, mesh.stars[node])) {
    const double angle = at_crack_front[other] ? options.crack_angle : options.snap_angle;
    const double distance = (positions[other] - positions[node]).norm();
    if (std::abs(sides.height(other)) <= std::sin(angle) * distance) sides.snap(other);
  }
}

/// Snaps surface faces at the separating node that are nearly parallel to the plane, so that no thin skin is cut off.
void snap_surface(const TetMesh& mesh, std::span<const Vec3> positions, NodeId node, const Vec3& normal, double angle,
                  PlaneSides& sides) {
  for (TetId tet : mesh.stars[node])
    for (int face = 0; face < 4; ++face) {
      if (mesh.neighbors[tet][face].valid() || mesh.tets[tet][face] == node) continue;
      const auto [a, b, c] = face_nodes(mesh, tet, face);
      const Vec3 area = (positions[b] - positions[a]).cross(positions[c] - positions[a]);
      if (std::abs(area.dot(normal)) < std::cos(angle) * area.norm()) continue;
      for (NodeId corner : {a, b, c}) sides.snap(corner);
    }
}

/// Snaps the nearer ends of edges that are crossed close to an end or must not be bisected. Returns the number of the
/// latter.
int snap_edges(const TetMesh& mesh, std::vector<CrossedEdge>& edges, const RemeshOptions& options, PlaneSides& sides) {
  int refused = 0;
  std::ranges::stable_sort(edges, {}, &CrossedEdge::fraction);
  for (const CrossedEdge& edge : edges) {
    if (!sides.crosses(edge.a, edge.b)) continue;
    const bool near = edge.fraction() < options.snap_fraction;
    if (!near && can_bisect(mesh, edge.a, edge.b, edge.weight, options.limits)) continue;
    refused += !near;
    sides.snap(edge.nearer_end());
  }
  std::erase_if(edges, [&](const CrossedEdge& edge) { return !sides.crosses(edge.a, edge.b); });
  return refused;
}

/// Bisects the edges, the longest first, which keeps shapes good. The tets around an edge may have changed since
/// snap_edges(). Returns the number of edges that must not be bisected after all.
int bisect_edges(TetMesh& mesh, std::vector<CrossedEdge>& edges, const BisectionLimits& limits, Subdivision& log) {
  int refused = 0;
  std::ranges::stable_sort(edges, std::ranges::greater{}, &CrossedEdge::length);
  for (const CrossedEdge& edge : edges) {
    if (can_bisect(mesh, edge.a, edge.b, edge.weight, limits)) {
      bisect_edge(mesh, edge.a, edge.b, edge.weight, log);
    } else {
      ++refused;
    }
  }
  return refused;
}

}  // namespace

StarCut cut_star(TetMesh& mesh, std::span<const Vec3> positions, std::span<const std::uint8_t> at_crack_front,
                 NodeId node, const Vec3& normal, const RemeshOptions& options) {
  PlaneSides sides(mesh, positions, node, normal);
  snap_near_nodes(mesh, positions, at_crack_front, node, options, sides);
  snap_surface(mesh, positions, node, normal, options.crack_angle, sides);
  std::vector<CrossedEdge> edges = crossed_edges(mesh, sides, node);

  StarCut cut;
  cut.refused_edges = snap_edges(mesh, edges, options, sides);
  cut.refused_edges += bisect_edges(mesh, edges, options.limits, cut.subdivision);
  cut.above = sides.tets_above(mesh, mesh.stars[node]);
  return cut;
}

}  // namespace griffith
