#include "sim/meshing/surface_edges.h"

#include <algorithm>
#include <tuple>

#include "sim/geometry/disjoint_sets.h"

namespace griffith {

std::vector<HalfEdge> half_edges(const TriangleSurface& surface) {
  std::vector<HalfEdge> sides;
  sides.reserve(3 * surface.triangles.size());
  for (std::size_t i = 0; i < surface.triangles.size(); ++i) {
    const auto& triangle = surface.triangles[i];
    for (int corner = 0; corner < 3; ++corner) {
      const int from = triangle[corner], to = triangle[(corner + 1) % 3];
      sides.push_back({std::min(from, to), std::max(from, to), static_cast<int>(i), from < to});
    }
  }
  const auto key = [](const HalfEdge& side) { return std::tuple(side.low, side.high, side.triangle); };
  std::sort(sides.begin(), sides.end(), [&](const HalfEdge& a, const HalfEdge& b) { return key(a) < key(b); });
  return sides;
}

std::vector<int> edge_connected_parts(const TriangleSurface& surface, const std::vector<HalfEdge>& sides,
                                      bool manifold_only) {
  const int count = static_cast<int>(surface.triangles.size());
  DisjointSets sets(count);
  for_each_edge(sides, [&](std::span<const HalfEdge> edge) {
    if (manifold_only && edge.size() != 2) return;
    for (const HalfEdge& side : edge) sets.join(edge.front().triangle, side.triangle);
  });
  std::vector<int> part(count);
  int parts = 0;
  for (int i = 0; i < count; ++i) part[i] = sets.find(i) == i ? parts++ : part[sets.find(i)];
  return part;
}

}  // namespace griffith
