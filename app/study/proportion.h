#pragma once

namespace griffith::app {

/// A probability estimated from trials.
struct Proportion {
  int successes = 0, trials = 0;

  bool mostly() const { return 2 * successes >= trials; }
  double estimate() const { return trials > 0 ? static_cast<double>(successes) / trials : 0; }
};

struct ConfidenceInterval {
  double low = 0, high = 1;
};

/// Returns Wilson's score interval of 95 % (E. B. Wilson, JASA 1927), valid also for few trials and for none or all
/// successes.
ConfidenceInterval wilson_interval(const Proportion& proportion);

}  // namespace griffith::app
