#pragma once

#include <string>
#include <vector>

#include "sim/core/ids.h"
#include "sim/core/linear_algebra.h"

namespace griffith::ui {

/// A crack of the next step, known because that step was made and undone.
struct ComingCrack {
  NodeId node;                      ///< node, in the numbering before the step
  double time = 0;                  ///< [s]
  double load = 0, resistance = 0;  ///< [Pa] or [N], by the criterion
  Vec3 normal = Vec3::UnitX();      ///< unit normal of its plane
  Vec3 eigenvalues = Vec3::Zero();  ///< eigenvalues of the separation tensor under which it opens, largest first [N]

  double utilization() const { return load / resistance; }
};

/// Reason why the simulation stopped by itself before a step; valid in that state and the microsteps of the step.
struct Stop {
  std::string reason;               ///< "Node 12 cracks in the next step."
  NodeId node;                      ///< existing node that cracks; invalid: none
  std::vector<ComingCrack> cracks;  ///< first crack of each existing node that cracks in the next step
};

}  // namespace griffith::ui
