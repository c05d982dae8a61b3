#pragma once

#include "sim/world/state/world_state.h"

namespace griffith {

/// Length of the substeps that soft bodies allow in a step.
struct StrainLimit {
  double longest = 0, shortest = 0;  ///< [s]
  int undone = 0;                    ///< substeps that were undone
};

/// Returns the limit for a step of this length [s].
StrainLimit strain_limit(const WorldState& world, double time_step);

/// Returns the depth of soft bodies below the ground, beyond that at rest, in sizes of their elements.
double depth_of_soft_bodies(const WorldState& world);

}  // namespace griffith
