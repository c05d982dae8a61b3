#include "app/study/proportion.h"

#include <algorithm>
#include <cmath>

namespace griffith::app {

ConfidenceInterval wilson_interval(const Proportion& proportion) {
  if (proportion.trials == 0) return {};
  constexpr double z = 1.959963984540054;  // quantile of the normal distribution for 95 %
  const double n = proportion.trials, p = proportion.estimate();
  const double center = (p + z * z / (2 * n)) / (1 + z * z / n);
  const double half = z / (1 + z * z / n) * std::sqrt(p * (1 - p) / n + z * z / (4 * n * n));
  return {std::max(0.0, center - half), std::min(1.0, center + half)};
}

}  // namespace griffith::app
