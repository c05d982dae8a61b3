#pragma once

#include <array>
#include <functional>
#include <vector>

#include "sim/meshing/surface.h"

namespace griffith {

/// A hierarchy of boxes round the triangles of a surface, for questions about the surface as a whole. It keeps what it
/// needs of the surface. Safe to ask from many threads at once.
class TriangleTree {
 public:
  explicit TriangleTree(const TriangleSurface& surface);

  struct Nearest {
    double distance = 0;  ///< [m]
    Vec3 point = Vec3::Zero();
    int triangle = -1;
  };
  /// The nearest point of the surface, which must have triangles.
  Nearest nearest(const Vec3& point) const;

  /// How often the surface is wrapped round `point` (Jacobson, Kavan & Sorkine-Hornung 2013): 1 inside and 0 outside of
  /// a closed surface, something in between near the holes of an open one. Far groups of triangles count as dipoles
  /// (Barill et al. 2018), which is wrong by 0.03 at most.
  double winding_number(const Vec3& point) const;

  /// Calls visit(triangle) for every triangle whose box meets `box`, until it returns false; whether it never did.
  bool visit_box(const Eigen::AlignedBox3d& box, const std::function<bool(int triangle)>& visit) const;

 private:
  struct Node {
    Eigen::AlignedBox3d box;
    int begin = 0, end = 0;                             ///< of a leaf: its triangles, as positions in order_
    int left = -1, right = -1;                          ///< of an inner node: its children
    Vec3 dipole = Vec3::Zero(), center = Vec3::Zero();  ///< sum of the area vectors, and the middle weighted by area
    double radius = 0;                                  ///< of the ball round `center` that holds the triangles
  };

  int build(int begin, int end);
  void set_dipole(Node& node) const;
  void find_nearest(int node, const Vec3& point, Nearest& best) const;
  double solid_angle(int node, const Vec3& point) const;
  bool visit_box(int node, const Eigen::AlignedBox3d& box, const std::function<bool(int)>& visit) const;

  std::vector<std::array<Vec3, 3>> triangles_;  ///< by triangle
  std::vector<int> order_;                      ///< triangles, those of a node next to each other
  std::vector<Node> nodes_;                     ///< the root first
};

}  // namespace griffith
