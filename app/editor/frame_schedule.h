#pragma once

#include <limits>

namespace griffith::app {

/// Waits of a window that draws only for a reason [s]. At once: something moves.
inline constexpr double kDrawAtOnce = 0, kDrawNever = std::numeric_limits<double>::infinity();

/// Decides how long a window may wait for events before it draws again. After anything that happened it draws some
/// frames, since menus, dialogs and what follows the mouse need a few to find their place.
class FrameSchedule {
 public:
  /// Something happened: an event came, a message was written.
  void wake() { settling_ = kFramesToSettle; }
  void drew() { settling_ -= settling_ > 0; }
  /// `wanted`: in how many seconds there is something else to draw.
  double seconds_to_wait(double wanted) const { return settling_ > 0 ? kDrawAtOnce : wanted; }

 private:
  static constexpr int kFramesToSettle = 8;
  int settling_ = kFramesToSettle;
};

}  // namespace griffith::app
