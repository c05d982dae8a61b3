#pragma once

#include <string>

#include "sim/world/frame.h"

namespace griffith::app {

/// Several lines that say why a node did or did not break: the verdict, its state and plane, its elements ranked by
/// what they add to the load. `fracture`: whether the scene lets bodies break.
std::string explanation(const Frame& frame, NodeId node, bool fracture);

}  // namespace griffith::app
