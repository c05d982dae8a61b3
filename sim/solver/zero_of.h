#pragma once

#include <cmath>

namespace griffith {

/// The zero, beyond 0, of a function that grows from below 0, to a hundredth of what it is at 0; 0 where it does not
/// begin below.
template <class Function>
double zero_of(const Function& function) {
  constexpr double kAccuracy = 0.01, kFarthest = 1e6;
  const double start = function(0.0);
  if (!(start < 0)) return 0;
  double low = 0, low_value = start, high = 1, high_value = function(high);
  if (std::abs(high_value) <= kAccuracy * -start) return high;
  while (high_value < 0) {
    low = high, low_value = high_value;
    if (high > kFarthest) return high;
    high *= 4, high_value = function(high);
  }
  double found = high;
  int side = 0;
  for (int i = 0; i < 40; ++i) {  // regula falsi, kept from getting stuck (Illinois: Dowell & Jarratt 1971)
    found = (low * high_value - high * low_value) / (high_value - low_value);
    const double here = function(found);
    if (std::abs(here) <= kAccuracy * -start) break;
    if (here < 0) {
      low = found, low_value = here;
      if (side < 0) high_value /= 2;
      side = -1;
    } else {
      high = found, high_value = here;
      if (side > 0) low_value /= 2;
      side = 1;
    }
  }
  return found;
}

}  // namespace griffith
