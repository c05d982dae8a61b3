#pragma once

namespace griffith::app {

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

}  // namespace griffith::app
