#pragma once

#include <vector>

#include "sim/core/lanes.h"
#include "sim/core/linear_algebra.h"
#include "sim/geometry/convex_hull.h"

namespace griffith::contact {

/// Convex polyhedron with its faces and edges, in the frame of its object [m]. A flat one has only corners.
struct Hull {
  struct Face {
    Vec3 normal;  ///< unit, outward
    double offset;
    int first, count;  ///< its corners: a range of `loops`, counter-clockwise seen from outside
  };
  struct Edge {
    int from, to;     ///< corners, in the order in which the left face has them
    int left, right;  ///< faces
  };

  explicit Hull(const ConvexHull& hull);

  bool is_solid() const { return !edges.empty(); }

  /// Returns the least of corners · direction.
  double lowest(const Vec3& direction) const;

  std::vector<Vec3> corners;
  std::vector<Face> faces;
  std::vector<int> loops;
  std::vector<Edge> edges;
  Vec3 center = Vec3::Zero();                               ///< center of the corners
  double inner_radius = 0;                                  ///< radius of the largest ball around it that no face cuts
  Vec3 box_center = Vec3::Zero(), box_half = Vec3::Zero();  ///< the box around them

 private:
  /// Coordinates of four corners; spare places repeat the last corner.
  struct Four {
    simd::DoubleLanes x, y, z;
  };
  std::vector<Four> fours_;
};

}  // namespace griffith::contact
