#pragma once

#include "sim/world/state/world_state.h"

namespace griffith {

/// Length of the substeps in a step, as far as deformable bodies limit it.
struct SubstepLimit {
  double longest = 0, shortest = 0;  ///< [s]
  double shortest_if_held = 0;       ///< lower limit where damping may hold a thin body [s]
  double last = 0;                   ///< length of the last substep [s]
  int undone = 0;                    ///< substeps that were undone since bodies strained or sank too far
  int late = 0;                      ///< substeps that were undone since cracks would begin late
};

/// Returns the limit by strains for a step of this length, after one that was not divided [s].
SubstepLimit strain_limit(const WorldState& world, double time_step);

/// Returns the depth of soft bodies below the ground, beyond that at rest, in sizes of their elements.
double depth_of_soft_bodies(const WorldState& world);

}  // namespace griffith
