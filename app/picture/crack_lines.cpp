#include "app/picture/crack_lines.h"

#include <algorithm>
#include <array>
#include <tuple>

#include "sim/mesh/tet_mesh.h"

namespace griffith::app {
namespace {

/// An edge of a face that was on the surface from the start; its ends by rest position.
struct SurfaceEdge {
  std::array<double, 6> rest;
  NodeId start, end;
  BodyId body;
  bool operator<(const SurfaceEdge& other) const {
    return std::tie(rest, body, start, end) < std::tie(other.rest, other.body, other.start, other.end);
  }
  /// True if a crack runs between the two edges.
  bool faces(const SurfaceEdge& other) const {
    return rest == other.rest && body == other.body && (start != other.start || end != other.end);
  }
};

SurfaceEdge surface_edge(const Frame& frame, TetId tet, NodeId start, NodeId end) {
  const auto place = [&](NodeId node) {
    const Vec3& rest = frame.nodes.rest_positions[node];
    return std::array{rest.x(), rest.y(), rest.z()};
  };
  std::array<double, 3> a = place(start), b = place(end);
  if (b < a) std::swap(a, b), std::swap(start, end);
  return {{a[0], a[1], a[2], b[0], b[1], b[2]}, start, end, frame.elements.bodies[tet]};
}

std::vector<SurfaceEdge> surface_edges(const std::vector<PictureTriangle>& triangles, const Frame& frame) {
  std::vector<SurfaceEdge> edges;
  for (const PictureTriangle& triangle : triangles) {
    if (triangle.face < 0 || !(frame.elements.first_surface[triangle.tet] >> triangle.face & 1)) continue;
    const auto corner = [&](int i) {
      const auto& face = kTetFaces[static_cast<std::size_t>(triangle.face)];
      return frame.elements.tets[triangle.tet][static_cast<std::size_t>(face[static_cast<std::size_t>(i)])];
    };
    for (int i = 0; i < 3; ++i) edges.push_back(surface_edge(frame, triangle.tet, corner(i), corner((i + 1) % 3)));
  }
  std::ranges::sort(edges, std::less());
  return edges;
}

}  // namespace

std::vector<render::Line> crack_lines(const std::vector<PictureTriangle>& triangles, const ShownMesh& shown) {
  constexpr render::Rgb kCrackLine = {0.16f, 0.14f, 0.13f};
  std::vector<render::Line> lines;
  if (shown.frame.crack_events.empty()) return lines;
  const std::vector<SurfaceEdge> edges = surface_edges(triangles, shown.frame);
  for (std::size_t i = 1; i < edges.size(); ++i) {
    if (!edges[i].faces(edges[i - 1])) continue;
    const Vec3 &start = shown.positions[edges[i].start], &end = shown.positions[edges[i].end];
    if (shown.visible(start) && shown.visible(end))
      lines.push_back({start.cast<float>(), end.cast<float>(), kCrackLine, render::kNoId});
  }
  return lines;
}

}  // namespace griffith::app
