#pragma once

#include <vector>

#include "sim/elasticity/principal_stress.h"
#include "sim/fracture/separation_tensor.h"
#include "sim/world/output/frame.h"

namespace griffith {

/// Element at a node, and its contribution to the load of the node.
struct ElementContribution {
  TetId tet;
  bool above = false;  ///< its middle lies on the side of the candidate plane to which the normal points
  SplitForce force;
  /// Contribution to v⁺, ½ n̂·(m(f_e⁺) − m(f_e⁻)) n̂ [N], or to the mean tensile stress [Pa], depending on
  /// NodeReport::by_tension.
  double contribution = 0;
};

/// Reasons of the separation of a node, or against it: the separation as evaluated, and the state in the frame.
struct NodeReport {
  NodeId node;
  BodyId body;
  /// Separation on which its utilization is based: averaged over substeps, before the cracks of the last one.
  NodeSeparation separation;

  // All of this comes from the frame's own stresses and adds up.
  bool strained = false;  ///< false in a rigid piece, whose stress is not computed: the rest is empty then
  PrincipalValues principal = {
      Vec3::Zero(), Mat3::Identity()};  ///< principal values and directions of the separation tensor, ascending [N]
  CandidatePlane plane;
  /// Stress across the plane [Pa], or by the criterion of the separation force v⁺ [N]; if the material has a strength
  /// surface, the equivalent tension [Pa].
  double load = 0;
  bool by_tension = false;  ///< the plane's stress is the mean tensile stress of the elements, not v⁺ per area
  std::vector<ElementContribution> elements;  ///< all at the node, the largest share first
  double balance = 0;                         ///< contribution of the sums of all forces to v⁺, usually negative [N]

  Vec3 normal() const {
    return by_tension ? plane.normal : plane.pulled;
  }  ///< normal of the plane to which the contributions belong
  /// Returns the sum of contributions and balance: v⁺ [N] or, by tension, the plane's stress [Pa].
  double sum() const { return by_tension ? plane.stress : plane.eigenvalue; }

  bool at_crack_front = false;
  bool supported = false;   ///< a support acts on the node
  std::vector<int> events;  ///< indices into Frame::crack_events: where this node separated before
};

/// Returns the report on a node of the frame. Nodes are identified by their place in rest space: copies by cracks have
/// the same events.
NodeReport node_report(const Frame& frame, NodeId node);

/// Returns the node closest to separation; invalid if there is none. Nodes of rigid pieces do not count, since their
/// stress is not computed.
NodeId most_loaded_node(const Frame& frame);

}  // namespace griffith
