#pragma once

namespace griffith::app {

/// A probability that some trials tell of.
struct Proportion {
  int successes = 0, trials = 0;

  bool mostly() const { return 2 * successes >= trials; }
  double estimate() const { return trials > 0 ? static_cast<double>(successes) / trials : 0; }
};

struct ConfidenceInterval {
  double low = 0, high = 1;
};

/// Wilson's score interval of 95 % (E. B. Wilson, JASA 1927): right also for few trials, and for none or all successes.
ConfidenceInterval wilson_interval(const Proportion& proportion);

}  // namespace griffith::app
