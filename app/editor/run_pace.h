#pragma once

#include <deque>
#include <utility>

namespace griffith::app {

/// Rate of events that come in portions: the mean over the last two seconds or, if a portion takes longer, over the
/// last one. Uses no clock but the given times.
class RateMeter {
 public:
  /// Adds `elapsed` [s], at the end of which `amount` came; 0: none.
  void add(double elapsed, double amount);
  /// Returns the amount per second; 0 before the first portion. An overdue portion counts as if it came now, so that
  /// the rate of something that stops tends to 0.
  double rate() const;
  void reset() { *this = {}; }

 private:
  struct Portion {
    double time = 0;   ///< time of arrival [s]
    double total = 0;  ///< sum of all amounts up to this one
  };
  double now_ = 0;
  std::deque<Portion> portions_ = {Portion{}};  ///< the mean begins at the first
};

/// Determines the number of time steps before the next picture, so that simulated time follows real time. Only the
/// number of steps per picture depends on the clock, never their results.
class StepPacer {
 public:
  /// Returns the number of steps due after `elapsed` [s] of real time at `speed` simulated seconds per second. At most
  /// as many as fit between two smooth pictures if one takes `step_cost` [s], but at least one if one is due.
  int steps_due(double elapsed, double speed, double time_step, double step_cost);

  /// Accounts for `elapsed` [s] of real time in which a step was in progress and no other could be made.
  void wait(double elapsed, double speed, double time_step);

  /// True if steps were dropped recently.
  bool falling_behind() const { return shortage_ > 0.1; }

  /// Resets the pacer after a pause or for a new scene.
  void reset() { *this = {}; }

 private:
  void follow(bool dropped);

  double debt_ = 0;  ///< simulated seconds that are due
  double shortage_ = 0;
};

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
