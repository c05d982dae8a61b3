#pragma once

#include <span>
#include <vector>

#include "sim/meshing/surface.h"

namespace griffith {

/// Edge of a triangle.
struct HalfEdge {
  int low = 0, high = 0;  ///< indices of its points
  int triangle = 0;
  bool forward = true;  ///< true if the triangle runs from `low` to `high`
};

/// Returns all sides of all triangles, ordered by the edge's points, then by triangle. The sides of one edge are
/// adjacent.
std::vector<HalfEdge> half_edges(const TriangleSurface& surface);

/// Calls visit(sides) for every edge with the span of its half edges.
template <class Visit>
void for_each_edge(const std::vector<HalfEdge>& sides, const Visit& visit) {
  for (std::size_t begin = 0, end = 0; begin < sides.size(); begin = end) {
    while (end < sides.size() && sides[end].low == sides[begin].low && sides[end].high == sides[begin].high) ++end;
    visit(std::span(sides).subspan(begin, end - begin));
  }
}

/// Returns the part of each triangle. Parts are connected through edges and numbered by their first triangles.
/// `manifold_only`: connect only through edges of two triangles.
std::vector<int> edge_connected_parts(const TriangleSurface& surface, const std::vector<HalfEdge>& sides,
                                      bool manifold_only);

}  // namespace griffith
