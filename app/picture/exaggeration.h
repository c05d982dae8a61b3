#pragma once

#include <vector>

#include "sim/world/output/frame.h"

namespace griffith::app {

/// Returns node positions with the deformation multiplied by `factor`: the displacement of each node from the best-fit
/// rigid placement of its piece (least squares). Held nodes dominate the fit, so that supports stay in place. A factor
/// of 1 keeps all bits. Positions that are not finite stay.
std::vector<Vec3> exaggerated_positions(const Frame& frame, double factor);

}  // namespace griffith::app
