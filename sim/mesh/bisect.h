#pragma once

#include <vector>

#include "sim/mesh/tet_mesh.h"

namespace griffith {

/// A node put on edge ab, at (1 − weight) a + weight b.
struct EdgeNode {
  NodeId node, a, b;
  double weight = 0;

  /// A quantity that is linear along the edge, at the node.
  template <class T>
  T interpolate(const T& at_a, const T& at_b) const {
    return (1 - weight) * at_a + weight * at_b;
  }
};

/// A tet halved across one of its edges. `tet` keeps the edge's end in corner `kept`, `child` is new and has the end in
/// corner `moved`; in both the new node takes the place of the other end. The other two corners are the same in both.
struct TetBisection {
  TetId tet, child;
  int kept = 0, moved = 0;
};

/// What bisections did to a mesh, in their order: a later one may concern nodes and tets made by earlier ones.
struct Subdivision {
  std::vector<EdgeNode> nodes;
  std::vector<TetBisection> tets;
};

/// What a bisection must not go below.
struct BisectionLimits {
  double min_length = 0;   ///< of an edge that it makes, in rest space [m]
  double min_quality = 0;  ///< of a tet that it makes, in rest space (tet_quality() in mesh_report.h)
};

/// Whether bisecting edge ab at `weight` respects the limits.
bool can_bisect(const TetMesh& mesh, NodeId a, NodeId b, double weight, const BisectionLimits& limits);

/// Halves every tet at edge ab (which must exist) by a node on it: one node, or one for each piece of a pinched edge.
/// All faces go on conforming, and the volume stays the same. With what is linear along the edge interpolated at the
/// new node, and masses lumped in quarters of the tets anew:
///   - mass, centre of mass and momentum stay the same, as do the deformation gradients of the tets;
///   - angular momentum changes by −Σ ¼ m weight (1 − weight) (x_a − x_b) × (v_a − v_b) over the halved tets of mass m;
///   - kinetic energy by −Σ ⅛ m weight (1 − weight) |v_a − v_b|²: it never grows.
/// Appends nodes and tets; the caller extends, by what is appended to `log`, whatever else it keeps for either.
void bisect_edge(TetMesh& mesh, NodeId a, NodeId b, double weight, Subdivision& log);

}  // namespace griffith
