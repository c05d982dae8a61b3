#include "ui/model/plot_view.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace griffith::ui {
namespace {

bool has_series(std::span<const RunSeries> there, const std::string& key) {
  return std::ranges::find(there, key, &RunSeries::key) != there.end();
}

}  // namespace

PlotRange plot_range(std::span<const RunCurve* const> curves) {
  constexpr double kRoom = 0.05, kNear = 0.5;
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const RunCurve* curve : curves)
    for (const double value : curve->values)
      if (std::isfinite(value)) low = std::min(low, value), high = std::max(high, value);
  if (low > high) return {};
  if (low > 0 && low < kNear * high) low = 0;
  if (high < 0 && high > kNear * low) high = 0;
  if (low == high) return low == 0 ? PlotRange{} : PlotRange{std::min(0.0, 2 * low), std::max(0.0, 2 * high)};
  const double room = kRoom * (high - low);
  return {low == 0 ? 0 : low - room, high == 0 ? 0 : high + room};
}

PlotRange decade_range(std::span<const RunCurve* const> curves) {
  constexpr double kMostDecades = 12;
  double low = std::numeric_limits<double>::infinity(), high = 0;
  for (const RunCurve* curve : curves)
    for (const double value : curve->values)
      if (std::isfinite(value) && value > 0) low = std::min(low, value), high = std::max(high, value);
  if (low > high) return {1, 10};
  const double last = std::ceil(std::log10(high)), first = std::floor(std::log10(low));
  return {std::pow(10, std::clamp(first, last - kMostDecades, last - 1)), std::pow(10, last)};
}

std::vector<double> decade_ticks(const PlotRange& range, double count) {
  const double first = std::round(std::log10(range.low)), last = std::round(std::log10(range.high));
  const double step = std::max(1.0, std::ceil((last - first) / std::max(1.0, count)));
  std::vector<double> ticks;
  for (double decade = first; decade <= last; decade += step) ticks.push_back(std::pow(10, decade));
  return ticks;
}

double PlotView::x(std::int64_t step) const {
  const double steps = static_cast<double>(std::max<std::int64_t>(1, last_step - first_step));
  return left + (right - left) * static_cast<double>(step - first_step) / steps;
}

double PlotView::y(double value) const {
  double fraction = (value - range.low) / (range.high - range.low);
  if (logarithmic) fraction = value > 0 ? std::log(value / range.low) / std::log(range.high / range.low) : 0;
  return bottom - std::clamp(fraction, 0.0, 1.0) * (bottom - top);
}

double PlotView::floor() const { return logarithmic ? 0 : -std::numeric_limits<double>::infinity(); }

std::int64_t PlotView::step_at(double x) const {
  if (right <= left) return first_step;
  const double fraction = std::clamp((x - left) / (right - left), 0.0, 1.0);
  return first_step + std::llround(fraction * static_cast<double>(last_step - first_step));
}

PlotSpan PlotView::span() const {
  const double steps = static_cast<double>(std::max<std::int64_t>(1, last_step - first_step));
  const double start = static_cast<double>(first_step) * time_step;
  return {start, start + steps * time_step, std::max(1, static_cast<int>(right - left))};
}

std::vector<PlotStrip> plot_strips(const RunCurves& curves) {
  std::vector<PlotStrip> strips;
  for (const RunCurve& curve : curves.curves) {
    auto strip = std::ranges::find(strips, curve.series.unit, &PlotStrip::unit);
    if (strip == strips.end()) strip = strips.insert(strips.end(), {curve.series.unit, {}, curves.times});
    strip->curves.push_back(&curve);
  }
  return strips;
}

RunCurves part_of(const RunCurves& curves, const StepSpan& steps) {
  const auto first = std::ranges::lower_bound(curves.steps, steps.first) - curves.steps.begin();
  const auto end = std::ranges::upper_bound(curves.steps, steps.last) - curves.steps.begin();
  RunCurves part;
  part.steps.assign(curves.steps.begin() + first, curves.steps.begin() + end);
  part.times.assign(curves.times.begin() + first, curves.times.begin() + end);
  for (const RunCurve& curve : curves.curves)
    part.curves.push_back({curve.series, curve.slot, {curve.values.begin() + first, curve.values.begin() + end}});
  return part;
}

StepSpan zoomed(const StepSpan& shown, const StepSpan& whole, std::int64_t fixed, double factor) {
  constexpr std::int64_t kFewest = 4;
  const std::int64_t before = std::max<std::int64_t>(1, shown.last - shown.first);
  std::int64_t length = std::llround(static_cast<double>(before) * factor);
  if (length == before) length += factor < 1 ? -1 : 1;
  length = std::max(length, kFewest);
  if (length >= whole.last - whole.first) return whole;
  const double place = static_cast<double>(fixed - shown.first) / static_cast<double>(before);
  const std::int64_t first = fixed - std::llround(place * static_cast<double>(length));
  return moved({first, first + length}, whole, 0);
}

StepSpan moved(const StepSpan& shown, const StepSpan& whole, std::int64_t steps) {
  const std::int64_t length = std::min(shown.last - shown.first, whole.last - whole.first);
  const std::int64_t first = std::clamp(shown.first + steps, whole.first, whole.last - length);
  return {first, first + length};
}

void toggle_series(PlotChoice& chosen, const std::string& key, std::span<const RunSeries> there) {
  const auto slot = std::ranges::find(chosen, key);
  if (slot != chosen.end()) return slot->clear();
  const auto free = std::ranges::find_if(chosen, [&](const std::string& taken) { return !has_series(there, taken); });
  if (free != chosen.end()) *free = key;
}

std::size_t count_series(const PlotChoice& chosen, std::span<const RunSeries> there) {
  return static_cast<std::size_t>(
      std::ranges::count_if(chosen, [&](const std::string& key) { return has_series(there, key); }));
}

}  // namespace griffith::ui
