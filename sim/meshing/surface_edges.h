#pragma once

#include <span>
#include <vector>

#include "sim/meshing/surface.h"

namespace griffith {

/// An edge as a triangle sees it.
struct HalfEdge {
  int low = 0, high = 0;  ///< its points, by number
  int triangle = 0;
  bool forward = true;  ///< whether the triangle runs from `low` to `high`
};

/// All sides of all triangles, those of one edge next to each other; ordered by the edge's points, then by triangle.
std::vector<HalfEdge> half_edges(const TriangleSurface& surface);

/// Calls visit(sides) for every edge with the span of its half edges.
template <class Visit>
void for_each_edge(const std::vector<HalfEdge>& sides, const Visit& visit) {
  for (std::size_t begin = 0, end = 0; begin < sides.size(); begin = end) {
    while (end < sides.size() && sides[end].low == sides[begin].low && sides[end].high == sides[begin].high) ++end;
    visit(std::span(sides).subspan(begin, end - begin));
  }
}

/// Per triangle, the number of the part that it belongs to; parts hold together through edges, and are numbered by
/// their first triangles. `manifold_only`: through edges of two triangles alone.
std::vector<int> edge_connected_parts(const TriangleSurface& surface, const std::vector<HalfEdge>& sides,
                                      bool manifold_only);

}  // namespace griffith
