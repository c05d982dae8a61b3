#pragma once

#include <vector>

#include "sim/mesh/tet_mesh.h"

namespace griffith {

/// Node placed on edge ab, at (1 − weight) a + weight b.
struct EdgeNode {
  NodeId node, a, b;
  double weight = 0;

  /// Returns the value at the node of a quantity that is linear along the edge.
  template <class T>
  T interpolate(const T& at_a, const T& at_b) const {
    return (1 - weight) * at_a + weight * at_b;
  }
};

/// Bisection of a tet across one of its edges. `tet` keeps the end of the edge in corner `kept`. `child` is new and has
/// the other end in corner `moved`. In both, the new node replaces the opposite end; the other two corners are shared.
struct TetBisection {
  TetId tet, child;
  int kept = 0, moved = 0;
  NodeId middle;  ///< the new node
};

/// Bisections of a mesh in order. Later ones may concern nodes and tets of earlier ones.
struct Subdivision {
  std::vector<EdgeNode> nodes;
  std::vector<TetBisection> tets;
};

/// Lower limits of a bisection.
struct BisectionLimits {
  double min_length = 0;   ///< length of new edges in rest space [m]
  double min_quality = 0;  ///< quality of new tets in rest space (tet_quality() in mesh_report.h)
};

/// True if a bisection of edge ab at `weight` respects the limits.
bool can_bisect(const TetMesh& mesh, NodeId a, NodeId b, double weight, const BisectionLimits& limits);

/// Bisects every tet at edge ab, which must exist, by a node on it: one node, or one for each piece of a pinched edge.
/// All faces still conform, and the volume is kept. With linear interpolation at the new node and masses lumped again
/// in quarters of the tets,
/// - mass, center of mass, momentum and the deformation gradients of the tets are kept;
/// - angular momentum changes by −Σ ¼ m weight (1 − weight) (x_a − x_b) × (v_a − v_b) over the bisected tets of mass m;
/// - kinetic energy changes by −Σ ⅛ m weight (1 − weight) |v_a − v_b|², so it never grows.
/// Appends nodes and tets. The caller extends its own data of both by the entries appended to `log`.
void bisect_edge(TetMesh& mesh, NodeId a, NodeId b, double weight, Subdivision& log);

}  // namespace griffith
