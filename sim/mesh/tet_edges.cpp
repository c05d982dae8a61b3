#include "sim/mesh/tet_edges.h"

#include <algorithm>
#include <map>

#include "sim/core/sort_unique.h"
#include "sim/mesh/topology.h"

namespace griffith {
namespace {

using Ends = std::array<NodeId, 2>;

Ends ends_of(const TetMesh& mesh, TetId tet, int edge) {
  const auto& corners = mesh.tets[tet];
  const auto [a, b] = std::minmax(corners[kTetEdges[edge][0]], corners[kTetEdges[edge][1]]);
  return {a, b};
}

/// True if some tet has both nodes.
bool is_edge(const TetMesh& mesh, const Ends& ends) {
  return std::ranges::any_of(mesh.stars[ends[0]], [&](TetId tet) { return local_corner(mesh, tet, ends[1]) >= 0; });
}

}  // namespace

void add_edges(const TetMesh& mesh, std::span<const TetId> tets, TetEdges& edges) {
  edges.of_tet.resize(mesh.tets.size());
  std::vector<Ends> added;
  for (const TetId tet : tets)
    for (int edge = 0; edge < 6; ++edge) added.push_back(ends_of(mesh, tet, edge));
  sort_unique(added);
  const int first = edges.edge_count();
  edges.ends.insert(edges.ends.end(), added.begin(), added.end());
  for (const TetId tet : tets)
    for (int edge = 0; edge < 6; ++edge)
      edges.of_tet[tet][edge] =
          EdgeId(first + (std::ranges::lower_bound(added, ends_of(mesh, tet, edge)) - added.begin()));
}

std::vector<EdgeId> edges_of(const TetEdges& edges, std::span<const TetId> tets) {
  std::vector<EdgeId> found;
  for (const TetId tet : tets)
    if (edges.is_quadratic(tet)) found.insert(found.end(), edges.of_tet[tet].begin(), edges.of_tet[tet].end());
  sort_unique(found);
  return found;
}

BisectedEdges bisect_edges(const EdgeNode& middle, std::span<const TetBisection> halves, TetEdges& edges) {
  BisectedEdges result;
  std::map<NodeId, EdgeId> known;  // by the ends beside the middle
  const auto add = [&](NodeId end, const std::array<EdgeId, 3>& from, const std::array<double, 3>& weights) {
    const auto [entry, is_new] = known.try_emplace(end, EdgeId(edges.edge_count()));
    if (is_new) {
      const auto [first, second] = std::minmax(end, middle.node);
      edges.ends.push_back({first, second});
      result.parts.push_back({entry->second, from, weights});
    }
    return entry->second;
  };
  const double t = middle.weight;
  for (const auto& [tet, child, kept, moved, node] : halves) {
    if (!edges.is_quadratic(tet)) return result;
    std::array<EdgeId, 6>&of_tet = edges.of_tet[tet], &of_child = edges.of_tet[child];
    of_child = of_tet;
    const EdgeId whole = result.bisected = of_tet[tet_edge(kept, moved)];
    of_tet[tet_edge(kept, moved)] = add(middle.a, {whole}, {t * t});
    of_child[tet_edge(kept, moved)] = add(middle.b, {whole}, {(1 - t) * (1 - t)});
    for (int corner = 0; corner < 4; ++corner) {
      if (corner == kept || corner == moved) continue;
      const EdgeId to_a = of_tet[tet_edge(kept, corner)], to_b = of_tet[tet_edge(moved, corner)];
      const std::array<NodeId, 2>& ends = edges.ends[to_a];
      const NodeId end = ends[0] == middle.a ? ends[1] : ends[0];
      of_tet[tet_edge(moved, corner)] = of_child[tet_edge(kept, corner)] =
          add(end, {to_a, to_b, whole}, {1 - t, t, -t * (1 - t)});
    }
  }
  return result;
}

std::vector<EdgeCopy> part_edges(const TetMesh& mesh, std::span<const NodeId> copied, TetEdges& edges) {
  std::vector<EdgeCopy> copies;
  std::map<Ends, EdgeId> parted;
  const auto part = [&](EdgeId edge, const Ends& now) {
    if (const auto known = parted.find(now); known != parted.end()) return known->second;
    if (is_edge(mesh, edges.ends[edge])) {
      copies.push_back({edge, EdgeId(edges.edge_count())});
      edge = copies.back().copy;
      edges.ends.push_back(now);
    }
    edges.ends[edge] = now;
    parted.emplace(now, edge);
    return edge;
  };
  for (const NodeId node : copied)
    for (const TetId tet : mesh.stars[node]) {
      if (!edges.is_quadratic(tet)) continue;
      for (int i = 0; i < 6; ++i)
        if (const Ends now = ends_of(mesh, tet, i); now != edges.ends[edges.of_tet[tet][i]])
          edges.of_tet[tet][i] = part(edges.of_tet[tet][i], now);
    }
  return copies;
}

}  // namespace griffith
