#include "app/shared/flip_search.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <numeric>

namespace griffith::app {
namespace {

bool is_narrow(const FlipSearch& search, const Bracket& flip, double range) {
  if (search.whole) return flip.above - flip.below <= 1;
  const double width = flip.above - flip.below;
  return width <= search.tolerance * (search.geometric ? flip.below : range);
}

/// Returns values that divide the interval into equal parts, without its ends.
std::vector<double> inner_values(const FlipSearch& search, const Bracket& flip) {
  std::vector<double> values;
  for (int i = 1; i <= search.values_at_a_time; ++i) {
    const double value = value_between(search, flip.below, flip.above, i / (search.values_at_a_time + 1.0));
    if (value > flip.below && value < flip.above && (values.empty() || value > values.back())) values.push_back(value);
  }
  return values;
}

void try_all(std::map<double, State>& tried, const std::vector<double>& values, const StateAt& state) {
  const std::vector<State> states = state(values);
  for (std::size_t i = 0; i < values.size(); ++i) tried[values[i]] = states[i];
}

/// Returns `outside` if it is allowed, else the nearest allowed value toward `inside`.
double furthest_allowed(double inside, double outside, const std::function<bool(double)>& allowed) {
  if (allowed(outside)) return outside;
  constexpr int kHalvings = 20;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = std::midpoint(inside, outside);
    (allowed(middle) ? inside : outside) = middle;
  }
  return inside;
}

/// Rounds to as many digits as values a tolerance apart need.
double rounded(double value, double tolerance) {
  char digits[32];
  std::snprintf(digits, sizeof digits, "%.*g", 3 + static_cast<int>(std::ceil(-std::log10(tolerance))), value);
  return std::strtod(digits, nullptr);
}

}  // namespace

StateAt states_of(const std::function<bool(double)>& holds) {
  return [holds, known = std::map<double, int>()](const std::vector<double>& values) mutable {
    std::vector<State> states;
    for (const double value : values) {
      const auto [state, is_new] = known.try_emplace(value);
      if (is_new) state->second = holds(value);
      states.push_back({state->second});
    }
    return states;
  };
}

double value_between(const FlipSearch& search, double low, double high, double fraction) {
  if (fraction <= 0) return low;
  if (fraction >= 1) return high;
  const double value = search.geometric ? low * std::pow(high / low, fraction) : std::lerp(low, high, fraction);
  return search.whole ? std::round(value) : rounded(value, search.tolerance);
}

std::map<double, State> search_flips(const FlipSearch& search, const std::vector<double>& values,
                                     const StateAt& state) {
  std::map<double, State> tried;
  try_all(tried, values, state);
  const double range = values.back() - values.front();
  for (bool narrowed = true; narrowed;) {
    narrowed = false;
    for (const Bracket& flip : flips_among(tried)) {
      const std::vector<double> inner = inner_values(search, flip);
      if (is_narrow(search, flip, range) || inner.empty() || tried.size() >= search.most_values) continue;
      try_all(tried, inner, state);
      narrowed = true;
    }
  }
  return tried;
}

std::vector<double> widened_until_flip(double start, int doublings, const std::function<bool(double)>& allowed,
                                       const StateAt& state) {
  std::map<double, State> tried;
  try_all(tried, {start}, state);
  double low = start, high = start;
  for (int i = 0; i < doublings && flips_among(tried).empty(); ++i) {
    low = furthest_allowed(low, low / 2, allowed);
    high = furthest_allowed(high, high * 2, allowed);
    try_all(tried, {low, high}, state);
  }
  std::vector<double> values;
  for (const auto& [value, there] : tried) values.push_back(value);
  return values;
}

}  // namespace griffith::app
