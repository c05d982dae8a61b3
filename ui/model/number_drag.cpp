#include "ui/model/number_drag.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace griffith::ui {
namespace {

constexpr double kSharePerPixel = 0.005;

bool is_ratio(const Numbers& numbers) { return numbers.unit.empty() || numbers.unit == "-"; }

bool is_logarithmic(const DragStart& start) {
  return !start.whole && start.numbers.minimum > 0 && start.numbers.maximum >= 100 * start.numbers.minimum;
}

/// Returns the usual magnitude of numbers of that unit in scenes up to the size of a house.
double usual_magnitude(std::string_view unit) {
  constexpr std::array<std::pair<std::string_view, double>, 3> kUsual = {{{"s", 0.1}, {"N", 1e3}, {"Pa", 1e6}}};
  const auto found = std::ranges::find(kUsual, unit, &std::pair<std::string_view, double>::first);
  return found == kUsual.end() ? 1 : found->second;
}

/// Returns the change per pixel for linear drags.
double linear_step(const DragStart& start) {
  constexpr double kLeastCount = 0.1, kHalfDegree = 0.5;
  const double magnitude = std::max(std::abs(start.value), start.vector_magnitude);
  if (start.whole) return std::max(kLeastCount, kSharePerPixel * magnitude);
  if (start.numbers.unit == "degrees") return kHalfDegree;
  if (is_ratio(start.numbers) && start.usual == 0)
    return kSharePerPixel * std::max(magnitude, std::min(1.0, start.numbers.maximum - start.numbers.minimum));
  if (magnitude > 0) return kSharePerPixel * magnitude;
  return kSharePerPixel * (start.usual > 0 ? start.usual : usual_magnitude(start.numbers.unit));
}

/// Returns the multiple of `digit` times a power of ten nearest to `value`, without trailing digits.
double rounded(double value, int digit, int exponent) {
  const double power = std::pow(10, std::abs(exponent));
  return exponent < 0 ? std::round(value * power / digit) * digit / power
                      : std::round(value / power / digit) * digit * power;
}

/// Rounds to a power of ten that is at most `step`, or with `snap` to 1, 2 or 5 times one that is at least `step`.
double on_grid(double value, double step, bool snap) {
  const int exponent = static_cast<int>(std::floor(std::log10(step) + 1e-9));
  if (!snap) return rounded(value, 1, exponent);
  const double mantissa = step / std::pow(10, exponent) * (1 - 1e-9);
  if (mantissa > 5) return rounded(value, 1, exponent + 1);
  return rounded(value, mantissa > 2 ? 5 : mantissa > 1 ? 2 : 1, exponent);
}

}  // namespace

double dragged_number(const DragStart& start, double moved, const DragPace& pace) {
  if (moved == 0) return start.value;
  const bool logarithmic = is_logarithmic(start);
  const double step = logarithmic ? 0 : linear_step(start);
  const double raw =
      std::clamp(logarithmic ? start.value * std::pow(1 + kSharePerPixel, moved) : start.value + moved * step,
                 start.numbers.minimum, start.numbers.maximum);
  const double grid = pace.factor() * (logarithmic ? kSharePerPixel * raw : step);
  const double result = on_grid(raw, start.whole ? std::max(1.0, grid) : grid, pace.coarse);
  return std::clamp(result, start.numbers.minimum, start.numbers.maximum);
}

}  // namespace griffith::ui
