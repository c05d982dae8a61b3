#pragma once

#include <vector>

#include "sim/elasticity/principal_stress.h"
#include "sim/fracture/separation_tensor.h"
#include "sim/world/frame.h"

namespace griffith {

/// An element at a node, and its part in pulling the node apart.
struct ElementContribution {
  TetId tet;
  bool above = false;  ///< its middle lies on the side of the candidate plane to which the normal points
  SplitForce force;
  /// Contribution to v⁺, ½ n̂·(m(f_e⁺) − m(f_e⁻)) n̂ [N], or to the mean tensile stress [Pa], depending on
  /// NodeReport::by_tension.
  double contribution = 0;
};

/// Why a node is about to separate, or is not: what was decided on, and what is there at the time of the frame.
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
  double load = 0;          ///< across the plane [Pa], or [N] by the criterion of the separation force
  bool by_tension = false;  ///< the load is the mean tensile stress of the elements, not v⁺ per area
  std::vector<ElementContribution> elements;  ///< all at the node, the largest share first
  double balance = 0;                         ///< what the sums of all forces add to v⁺, mostly against it [N]

  Vec3 normal() const {
    return by_tension ? plane.normal : plane.pulled;
  }  ///< normal of the plane to which the contributions belong
  /// What shares and balance add up to: v⁺ [N] or, by tension, the load [Pa].
  double sum() const { return by_tension ? load : plane.eigenvalue; }

  bool at_crack_front = false;
  bool supported = false;   ///< a support acts on the node
  std::vector<int> events;  ///< indices into Frame::crack_events: where this node separated before
};

/// The report on a node of the frame. A node is known again by its place in rest space: copies that cracks made have
/// the same events.
NodeReport node_report(const Frame& frame, NodeId node);

/// The node nearest to separating; invalid where there are none. Nodes of rigid pieces do not count: nothing is known
/// of their stress.
NodeId most_loaded_node(const Frame& frame);

}  // namespace griffith
