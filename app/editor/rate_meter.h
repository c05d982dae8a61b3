#pragma once

#include <deque>

namespace griffith::app {

/// Rate of something that comes in portions: the mean over the last two seconds or, where a portion takes longer, over
/// the last one. Knows no clock but what it is told.
class RateMeter {
 public:
  /// `elapsed` [s] went by, at the end of which `amount` came; 0: nothing did.
  void add(double elapsed, double amount);
  /// Amount per second; 0 before the first portion. What is on its way counts as if it came now where it is late, so
  /// that the rate of something that stops goes to 0.
  double rate() const;
  void reset() { *this = {}; }

 private:
  struct Portion {
    double time = 0;   ///< when it came [s]
    double total = 0;  ///< sum of all amounts up to this one
  };
  double now_ = 0;
  std::deque<Portion> portions_ = {Portion{}};  ///< the first is where the mean begins
};

}  // namespace griffith::app
