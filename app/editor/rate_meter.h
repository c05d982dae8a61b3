#pragma once

#include <deque>

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

}  // namespace griffith::app
