#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <vector>

#include "sim/geometry/triangle.h"
#include "sim/mesh/tet_mesh.h"
#include "sim/world/output/frame.h"

namespace griffith::testing {

/// A node of one piece within another.
struct Overlap {
  int inner = -1, outer = -1;      ///< pieces; −1: there is none
  double depth = 0, fraction = 0;  ///< from the surface of the outer one [m], and of the smaller piece's size
};

/// Pieces as the frame shows them: their nodes, tets, boxes and surfaces, whatever stands in for them in contact.
class PieceGeometry {
 public:
  explicit PieceGeometry(const Frame& frame)
      : frame_(frame), tets_(frame.bodies.size()), nodes_(frame.bodies.size()), boxes_(frame.bodies.size()) {
    for (std::size_t tet = 0; tet < frame.elements.tets.size(); ++tet) tets_[body_of(tet)].push_back(tet);
    for (std::size_t node = 0; node < frame.nodes.positions.size(); ++node) {
      if (frame.nodes.stars[node].empty()) continue;
      const std::size_t body = body_of(static_cast<std::size_t>(frame.nodes.stars[node].front().index()));
      nodes_[body].push_back(node);
      boxes_[body].extend(frame.nodes.positions[node]);
    }
  }

  int pieces() const { return static_cast<int>(tets_.size()); }
  const Eigen::AlignedBox3d& bounds(int piece) const { return boxes_[piece]; }

  /// The deepest that a node of `inner` lies within a tet of `outer` [m]; 0: none does.
  double depth(int inner, int outer) const {
    double deepest = 0;
    if (!boxes_[inner].intersects(boxes_[outer])) return deepest;
    for (const std::size_t node : nodes_[inner]) {
      const Vec3& point = frame_.nodes.positions[node];
      if (boxes_[outer].contains(point) && is_within(outer, point))
        deepest = std::max(deepest, distance_to_surface(outer, point));
    }
    return deepest;
  }

 private:
  std::size_t body_of(std::size_t tet) const { return static_cast<std::size_t>(frame_.elements.bodies[tet].index()); }
  const Vec3& corner(std::size_t tet, int i) const { return frame_.nodes.positions[frame_.elements.tets[tet][i]]; }

  bool is_within(int piece, const Vec3& point) const {
    return std::ranges::any_of(tets_[piece], [&](std::size_t tet) {
      Mat3 edges;
      for (int i = 0; i < 3; ++i) edges.col(i) = corner(tet, i + 1) - corner(tet, 0);
      const Vec3 weights = edges.partialPivLu().solve(point - corner(tet, 0));
      return weights.minCoeff() > 0 && weights.sum() < 1;
    });
  }

  double distance_to_surface(int piece, const Vec3& point) const {
    double least = std::numeric_limits<double>::infinity();
    for (const std::size_t tet : tets_[piece])
      for (int face = 0; face < 4; ++face) {
        if (frame_.elements.neighbors[tet][face].valid()) continue;
        const auto& [a, b, c] = kTetFaces[face];
        const Vec3 weights = closest_on_triangle(point, {corner(tet, a), corner(tet, b), corner(tet, c)});
        const Vec3 closest = weights[0] * corner(tet, a) + weights[1] * corner(tet, b) + weights[2] * corner(tet, c);
        least = std::min(least, (closest - point).norm());
      }
    return least;
  }

  const Frame& frame_;
  std::vector<std::vector<std::size_t>> tets_, nodes_;
  std::vector<Eigen::AlignedBox3d> boxes_;
};

/// The overlap of two pieces that is the largest share of the smaller one's size.
inline Overlap worst_overlap(const Frame& frame) {
  const PieceGeometry geometry(frame);
  Overlap worst;
  for (int inner = 0; inner < geometry.pieces(); ++inner)
    for (int outer = 0; outer < geometry.pieces(); ++outer) {
      if (inner == outer) continue;
      const double depth = geometry.depth(inner, outer);
      const double size = std::min(geometry.bounds(inner).diagonal().norm(), geometry.bounds(outer).diagonal().norm());
      if (depth > worst.fraction * size) worst = {inner, outer, depth, depth / size};
    }
  return worst;
}

}  // namespace griffith::testing
