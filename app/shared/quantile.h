#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace griffith::app {

/// Returns the quantile at `fraction` (0..1) of the values, which must be numbers, interpolated between neighbors; 0
/// without any. Changes their order.
template <class Number>
Number quantile_of(std::vector<Number>& values, double fraction) {
  if (values.empty()) return 0;
  const double place = fraction * static_cast<double>(values.size() - 1);
  const auto below = values.begin() + static_cast<std::ptrdiff_t>(place);
  std::nth_element(values.begin(), below, values.end());
  const auto weight = static_cast<Number>(place - std::floor(place));
  if (weight == 0) return *below;
  const Number above = *std::min_element(below + 1, values.end());
  return *below == above ? above : (1 - weight) * *below + weight * above;
}

/// Returns the quantile of the values that are numbers.
template <class Number>
Number quantile(std::vector<Number> values, double fraction) {
  std::erase_if(values, [](Number value) { return std::isnan(value); });
  return quantile_of(values, fraction);
}

/// Returns the finite values.
template <class Number>
std::vector<Number> finite(std::vector<Number> values) {
  std::erase_if(values, [](Number value) { return !std::isfinite(value); });
  return values;
}

}  // namespace griffith::app
