#pragma once

#include <vector>

#include "sim/world/frame.h"

namespace griffith::app {

/// Node positions with `factor` times the deformation: every piece stays where the rigid motion puts it that fits its
/// nodes best (least squares), and a node's distance from there is multiplied. Held nodes decide the motion, so that
/// supports stay where they are. A factor of 1 changes nothing, to the bit. Places that are not finite stay.
std::vector<Vec3> exaggerated_positions(const Frame& frame, double factor);

}  // namespace griffith::app
