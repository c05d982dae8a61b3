#pragma once

#include <string>
#include <vector>

#include "sim/core/ids.h"

namespace griffith::ui {

/// A crack that opens in the next step, as is known once that step was made and taken back.
struct ComingCrack {
  NodeId node;                      ///< as the state before the step numbers it
  double time = 0;                  ///< [s]
  double load = 0, resistance = 0;  ///< [Pa] or [N], by the criterion
};

/// Why the simulation stopped by itself before a step. It is true of the state that it stopped in alone.
struct Stop {
  std::string reason;               ///< "Node 12 cracks in the next step."
  NodeId node;                      ///< that cracks and is there already; invalid: none
  std::vector<ComingCrack> cracks;  ///< first one of each node that cracks in the next step and is there already
};

}  // namespace griffith::ui
