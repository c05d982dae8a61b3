#pragma once

#include <string>

#include "sim/world/output/frame.h"

namespace griffith::app {

/// Explains in several lines why a node broke or holds: verdict, state and plane, and the elements ranked by their
/// share of the load. `fracture`: the scene lets bodies break.
std::string explanation(const Frame& frame, NodeId node, bool fracture);

}  // namespace griffith::app
