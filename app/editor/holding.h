#pragma once

#include <functional>

#include "sim/world/world.h"

namespace griffith::app {

/// What a factor has to be for something to hold, found by trying.
struct HoldingFactor {
  double breaks = 1, holds = 1;  ///< tried: at the first it does not hold, at the second it does
  bool breaks_at_one = true;     ///< else the crack depends on more than what was changed
  bool found = false;            ///< else nothing up to the largest factor holds
  int runs = 0;
};

/// The least factor of at least 1, to within 1 %, from which `holds` is true, by doubling and halving intervals; up to
/// `largest`. Where it is true now and then, one of the borders is found.
HoldingFactor holding_factor(const std::function<bool(double)>& holds, double largest = 1024);

/// How much stronger (tensile strength, toughness and what else resists) the material of a scene body would have to be
/// for no crack to open at a node in the next step of `before`; found by making the step again and again.
HoldingFactor strength_that_holds(const World& before, int scene_body, NodeId node);

}  // namespace griffith::app
