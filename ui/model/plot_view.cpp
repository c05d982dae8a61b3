#include "ui/model/plot_view.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace griffith::ui {

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

double PlotView::x(std::int64_t step) const {
  const double steps = static_cast<double>(std::max<std::int64_t>(1, last_step - first_step));
  return left + (right - left) * static_cast<double>(step - first_step) / steps;
}

double PlotView::y(double value) const {
  const double fraction = std::clamp((value - range.low) / (range.high - range.low), 0.0, 1.0);
  return bottom - fraction * (bottom - top);
}

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
    if (strip == strips.end()) strip = strips.insert(strips.end(), {curve.series.unit, {}});
    strip->curves.push_back(&curve);
  }
  return strips;
}

void toggle_series(PlotChoice& chosen, const std::string& key) {
  const auto slot = std::ranges::find(chosen, key);
  if (slot != chosen.end()) {
    slot->clear();
  } else if (const auto free = std::ranges::find(chosen, std::string()); free != chosen.end()) {
    *free = key;
  }
}

std::size_t count_series(const PlotChoice& chosen) {
  return static_cast<std::size_t>(std::ranges::count_if(chosen, [](const std::string& key) { return !key.empty(); }));
}

}  // namespace griffith::ui
