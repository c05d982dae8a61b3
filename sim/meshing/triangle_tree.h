#pragma once

#include <array>
#include <functional>
#include <vector>

#include "sim/meshing/surface.h"

namespace griffith {

/// Bounding volume hierarchy of a surface's triangles, for queries about the whole surface. It copies all data it
/// needs. Queries are thread-safe.
class TriangleTree {
 public:
  explicit TriangleTree(const TriangleSurface& surface);

  struct Nearest {
    double distance = 0;  ///< [m]
    Vec3 point = Vec3::Zero();
    int triangle = -1;
  };
  /// Returns the nearest point of the surface, which must have triangles.
  Nearest nearest(const Vec3& point) const;

  /// Returns the winding number of the surface around `point` (Jacobson, Kavan & Sorkine-Hornung 2013): 1 inside and 0
  /// outside a closed surface, in between near holes of an open one. Distant groups of triangles count as dipoles
  /// (Barill et al. 2018), with an error of at most 0.03.
  double winding_number(const Vec3& point) const;

  /// Calls visit(triangle) for every triangle whose box meets `box`, until it returns false. Returns true if it never
  /// did.
  bool visit_box(const Eigen::AlignedBox3d& box, const std::function<bool(int triangle)>& visit) const;

 private:
  struct Node {
    Eigen::AlignedBox3d box;
    int begin = 0, end = 0;                             ///< leaf: range of its triangles in order_
    int left = -1, right = -1;                          ///< inner node: its children
    Vec3 dipole = Vec3::Zero(), center = Vec3::Zero();  ///< sum of the area vectors, and the center weighted by area
    double radius = 0;  ///< radius of the ball around `center` that contains the triangles [m]
  };

  int build(int begin, int end);
  void set_dipole(Node& node) const;
  void find_nearest(int node, const Vec3& point, Nearest& best) const;
  double solid_angle(int node, const Vec3& point) const;
  bool visit_box(int node, const Eigen::AlignedBox3d& box, const std::function<bool(int)>& visit) const;

  std::vector<std::array<Vec3, 3>> triangles_;  ///< corners by triangle
  std::vector<int> order_;                      ///< triangles, those of a node adjacent
  std::vector<Node> nodes_;                     ///< root first
};

}  // namespace griffith
