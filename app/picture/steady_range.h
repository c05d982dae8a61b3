#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "app/picture/quantities.h"
#include "sim/core/linear_algebra.h"
#include "sim/world/frame.h"

namespace griffith::app {

/// The automatic range of the colours, without jumps from step to step: each end moves outwards at once and back
/// inwards by a small part of the way a time step. It depends on the steps that it followed alone, not on when pictures
/// were drawn.
class SteadyRange {
 public:
  /// Takes in the frame of a step, none left out; again the same step changes nothing. Another quantity than before, or
  /// an earlier step, starts anew. `values`: of the quantity in that frame, for whoever has them.
  void follow(const Frame& frame, const std::string& quantity, const QuantityValues* values = nullptr);
  /// The next frame is of another world.
  void restart() { quantity_.clear(); }

  /// Range of the quantity that was followed last; nothing where that is no scalar.
  const std::optional<Vec2>& range() const { return range_; }

 private:
  std::string quantity_;  ///< empty: followed none yet
  std::int64_t step_ = 0;
  std::optional<Vec2> range_;
};

}  // namespace griffith::app
