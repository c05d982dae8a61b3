#pragma once

#include <limits>

namespace griffith::app {

/// Waiting times of a window that draws on demand [s]. At once: something moves.
inline constexpr double kDrawAtOnce = 0, kDrawNever = std::numeric_limits<double>::infinity();

/// Delay before the window shows that work is in progress [s].
inline constexpr double kBusyIndicatorDelay = 0.3;

/// Returns the time that a window may wait for events before it draws. After any event, and after the end of what went
/// on by itself, it draws some frames, since menus, dialogs and items under the mouse need a few to find their place.
class FrameSchedule {
 public:
  /// Records an event or a message.
  void wake() { settling_ = kFramesToSettle; }
  void drew() { settling_ -= settling_ > 0; }
  /// `until_next`: seconds until something else must be drawn; they grow when something ends, such as work with a
  /// report.
  double seconds_to_wait(double until_next) {
    if (until_next > until_next_) wake();
    until_next_ = until_next;
    return settling_ > 0 ? kDrawAtOnce : until_next;
  }

 private:
  static constexpr int kFramesToSettle = 8;
  int settling_ = kFramesToSettle;
  double until_next_ = kDrawAtOnce;  // when last asked [s]
};

}  // namespace griffith::app
