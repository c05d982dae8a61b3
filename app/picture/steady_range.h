#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "app/picture/quantities.h"
#include "sim/core/linear_algebra.h"
#include "sim/world/output/frame.h"

namespace griffith::app {

/// Automatic range of colors without jumps between steps: each end moves outward at once and back inward by a small
/// fraction of the distance per time step. It depends on the followed steps alone, not on when pictures were drawn.
class SteadyRange {
 public:
  /// Updates the range with the frame of the next step. Repeating a step changes nothing; another quantity or an
  /// earlier step restarts the range. `values`: of the quantity in that frame, if already computed.
  void follow(const Frame& frame, const std::string& quantity, const QuantityValues* values = nullptr);
  /// Restarts the range for another world.
  void restart() { quantity_.clear(); }

  /// Returns the range of the last quantity; empty if it is no scalar.
  const std::optional<Vec2>& range() const { return range_; }

 private:
  std::string quantity_;  ///< empty: none followed yet
  std::int64_t step_ = 0;
  std::optional<Vec2> range_;
};

}  // namespace griffith::app
