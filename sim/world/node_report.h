#pragma once

#include <vector>

#include "sim/elasticity/principal_stress.h"
#include "sim/world/frame.h"

namespace griffith {

/// An element at a node, and its part in pulling the node apart.
struct ElementShare {
  TetId tet;
  bool above = false;  ///< its middle lies on the side of the candidate plane to which the normal points
  SplitForce force;
  double share = 0;  ///< ½ n̂·(m(f_e⁺) − m(f_e⁻)) n̂, what it adds to the eigenvalue [N]
};

/// Why a node is about to separate, or is not.
struct NodeReport {
  NodeId node;
  BodyId body;
  NodeSeparation separation;
  PrincipalValues principal;           ///< of the separation tensor, ascending [N]
  std::vector<ElementShare> elements;  ///< all at the node, the largest share first
  double balance = 0;                  ///< what the sums of all forces add to the eigenvalue, mostly against it [N]
  bool at_crack_front = false;
  bool supported = false;   ///< a support acts on the node
  std::vector<int> events;  ///< indices into Frame::crack_events: where this node separated before
};

/// The report on a node of the frame. Shares and balance add up to the separation's n̂·ς n̂. A node is known again by its
/// place in rest space: copies that cracks made have the same events.
NodeReport node_report(const Frame& frame, NodeId node);

/// The node nearest to separating; invalid where there are none. Nodes of rigid pieces do not count: nothing is known
/// of their stress.
NodeId most_loaded_node(const Frame& frame);

}  // namespace griffith
