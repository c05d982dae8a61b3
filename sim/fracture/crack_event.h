#pragma once

#include <cstdint>

#include "sim/ids.h"
#include "sim/linear_algebra.h"

namespace griffith {

/// One node that separated.
struct CrackEvent {
  std::int64_t step = 0;
  BodyId body;        ///< the body that cracked
  NodeId node;        ///< the node that was split
  Vec3 position, rest_position;  ///< [m]
  Vec3 normal;        ///< of the crack plane, world frame
  double load = 0, resistance = 0;  ///< [Pa] or [N], by the criterion
  int nodes_made = 0; ///< copies made at the node and its neighbours
};

}  // namespace griffith
