#pragma once

#include <algorithm>
#include <optional>
#include <utility>

namespace griffith::testing {

/// Finds the tops of what bounces, step by step.
class BounceTops {
 public:
  /// `height` and whether it rises after a step; the height of the top that it has just passed, if it has [m].
  std::optional<double> passed(double height, bool rises) {
    if (rises) top_ = std::max(top_, height);
    const bool turned = rose_ && !rises;
    rose_ = rises;
    if (!turned) return {};
    ++count_;
    return std::exchange(top_, 0);
  }
  int count() const { return count_; }

 private:
  double top_ = 0;
  bool rose_ = false;
  int count_ = 0;
};

}  // namespace griffith::testing
