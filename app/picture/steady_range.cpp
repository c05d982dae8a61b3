#include "app/picture/steady_range.h"

#include <algorithm>

#include "app/picture/quantities.h"

namespace griffith::app {

void SteadyRange::follow(const Frame& frame, const std::string& quantity, const QuantityValues* values) {
  constexpr double kReturn = 0.08;  // fraction of the distance inward per step: half of it in 8 steps
  const bool goes_on = quantity == quantity_ && frame.step >= step_;
  if (goes_on && frame.step == step_) return;
  quantity_ = quantity;
  step_ = frame.step;
  if (!is_scalar(quantity)) return range_.reset();
  const Vec2 now = values ? automatic_range(frame, quantity, *values)
                          : automatic_range(frame, quantity, linear_values(frame, *find_view_quantity(quantity)));
  if (!goes_on) {
    range_ = now;
    return;
  }
  const Vec2 eased = *range_ + kReturn * (now - *range_);
  range_ = Vec2(std::min(now[0], eased[0]), std::max(now[1], eased[1]));
}

}  // namespace griffith::app
