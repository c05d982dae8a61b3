#pragma once

#include <algorithm>

namespace griffith::app {

/// Decides when the view is drawn in draft quality: while the camera moves or steps lag, if a full picture takes so
/// long that motion would not be smooth. Off unless allowed, so that pictures of files and tests are always full.
class DraftQuality {
 public:
  /// `smooth`: longest time of a picture in smooth motion [s].
  void allow(double smooth = 0.03) {
    allowed_ = true;
    smooth_ = smooth;
  }
  bool allowed() const { return allowed_; }

  /// Records a drawn frame. `hurried`: the camera moved in it, or steps lag.
  void follow(bool hurried) { still_frames_ = hurried ? 0 : std::min(still_frames_ + 1, kFramesToSettle); }
  /// Records the time that a full picture took [s].
  void drew_full(double seconds) { full_seconds_ = seconds; }

  /// True if the next picture is a draft.
  bool on() const { return allowed_ && full_seconds_ > smooth_ && still_frames_ < kFramesToSettle; }

 private:
  static constexpr int kFramesToSettle = 6;  // a hand that rests for a moment still holds the camera

  bool allowed_ = false;
  double smooth_ = 0, full_seconds_ = 0;
  int still_frames_ = kFramesToSettle;
};

}  // namespace griffith::app
