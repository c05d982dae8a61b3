#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "sim/core/ids.h"
#include "sim/core/linear_algebra.h"
#include "sim/fracture/scaled_impact.h"
#include "sim/fracture/separation_tensor.h"

namespace griffith {

/// An element at a node that separated, and what it did to the node just before.
struct CrackElement {
  TetId tet;
  bool above = false;  ///< on the side of the plane to which the normal points
  SplitForce force;
};

/// One node that separated.
struct CrackEvent {
  std::int64_t step = 0;
  double time = 0;  ///< [s], to the substep
  BodyId body;      ///< the body that cracked
  std::vector<BodyId>
      children;  ///< bodies that its pieces at the node belong to now, `body` among them; empty: still one
  NodeId node;   ///< the node that was split
  Vec3 position, rest_position;        ///< [m]
  Vec3 normal;                         ///< of the crack plane, world frame
  double eigenvalue = 0;               ///< v⁺ of the separation tensor [N]
  double load = 0, resistance = 0;     ///< [Pa] or [N], by the criterion
  int nodes_made = 0;                  ///< copies made at the node and its neighbours
  bool torn_off = false;               ///< a support lost its hold on elements at the node
  std::vector<CrackElement> elements;  ///< all at the node, by tet
  std::optional<ScaledImpact> scaled;  ///< what stood in for the material, where something did
};

}  // namespace griffith
