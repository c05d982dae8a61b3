#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "sim/core/ids.h"
#include "sim/core/linear_algebra.h"
#include "sim/fracture/scaled_impact.h"
#include "sim/fracture/separation_tensor.h"

namespace griffith {

/// Element at a node that separated, and its forces on the node just before.
struct CrackElement {
  TetId tet;
  bool above = false;  ///< true on the side of the plane to which the normal points
  SplitForce force;
};

/// Separation of one node.
struct CrackEvent {
  std::int64_t step = 0;
  double time = 0;  ///< time of the substep [s]
  BodyId body;      ///< body that cracked
  std::vector<BodyId>
      children;  ///< bodies of its pieces at the node afterward, including `body`; empty: still one body
  NodeId node;   ///< node that was split
  Vec3 position, rest_position;        ///< [m]
  Vec3 normal;                         ///< normal of the crack plane, world frame
  double eigenvalue = 0;               ///< v⁺, largest eigenvalue of the separation tensor [N]
  double load = 0, resistance = 0;     ///< [Pa] or [N], depending on the criterion
  int nodes_made = 0;                  ///< copies made at the node and its neighbors
  bool torn_off = false;               ///< true if a support lost its hold on elements at the node
  std::vector<CrackElement> elements;  ///< all elements at the node, by tet
  std::optional<ScaledImpact> scaled;  ///< scaled material, if the body was scaled
};

}  // namespace griffith
