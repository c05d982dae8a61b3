#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace griffith::app {

/// What lies at `fraction` (0..1) of the sorted finite values; 0 without any.
template <class Number>
Number quantile(std::vector<Number> values, double fraction) {
  std::erase_if(values, [](Number value) { return !std::isfinite(value); });
  if (values.empty()) return 0;
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(fraction * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

}  // namespace griffith::app
