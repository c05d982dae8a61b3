#pragma once

#include <utility>

#include "app/editor/rate_meter.h"
#include "app/editor/step_pacer.h"

namespace griffith::app {

/// Measured speeds of a run.
class RunPace {
 public:
  /// Counts a drawn picture `elapsed` [s] of real time after the last one.
  void add_picture(double elapsed) {
    pictures_.add(elapsed, 1);
    time_made_.add(elapsed, std::exchange(unread_time_, 0));  // steps since the last picture count at its end
  }
  /// Counts a step of `time` [s] that took `seconds` of real time.
  void add_step(double time, double seconds) {
    constexpr double kNewest = 0.1;  // weight of the newest step in the mean
    unread_time_ += time;
    step_seconds_ = step_seconds_ == 0 ? seconds : step_seconds_ + kNewest * (seconds - step_seconds_);
  }
  /// Restarts the measurements after a pause; the duration of a step stays known.
  void restart() { *this = RunPace(step_seconds_); }

  StepPacer& pacer() { return pacer_; }
  bool falling_behind() const { return pacer_.falling_behind(); }
  /// Smoothed duration of a step [s]; 0 before the first.
  double step_seconds() const { return step_seconds_; }
  double pictures_per_second() const { return pictures_.rate(); }
  /// Simulated time per second of real time.
  double reached_speed() const { return time_made_.rate(); }

  RunPace() = default;

 private:
  explicit RunPace(double step_seconds) : step_seconds_(step_seconds) {}

  StepPacer pacer_;
  RateMeter pictures_, time_made_;
  double unread_time_ = 0;  ///< time simulated since the last picture [s]
  double step_seconds_ = 0;
};

}  // namespace griffith::app
