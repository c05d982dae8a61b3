#pragma once

namespace griffith::app {

/// Decides how many time steps to make before the next picture, so that simulated time follows real time. Only the
/// number of steps per picture depends on the clock, never what a step computes.
class StepPacer {
 public:
  /// Steps due after `elapsed` [s] of real time at `speed` simulated seconds per second. At most as many as fit in the
  /// time between two smooth pictures, given that one takes `step_cost` [s], but at least one when one is due.
  int steps_due(double elapsed, double speed, double time_step, double step_cost);

  /// After `elapsed` [s] of real time in which a step was on its way and no other could be made.
  void wait(double elapsed, double speed, double time_step);

  /// Whether steps had to be dropped lately.
  bool falling_behind() const { return shortage_ > 0.1; }

  /// Forgets the past: after a pause or a new scene.
  void reset() { *this = {}; }

 private:
  void follow(bool dropped);

  double debt_ = 0;  ///< simulated seconds that are due
  double shortage_ = 0;
};

}  // namespace griffith::app
