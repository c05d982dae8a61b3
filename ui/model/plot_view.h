#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "ui/model/plot_columns.h"
#include "ui/model/run_curves.h"

namespace griffith::ui {

/// The values at the lower and the upper end of a plot.
struct PlotRange {
  double low = 0, high = 1;
};

/// A range that holds all finite values, with a little room, and 0 where that is not far. Never empty.
PlotRange plot_range(std::span<const RunCurve* const> curves);

/// Where steps and values are in a plot; places are in pixels, downwards and to the right.
struct PlotView {
  double left = 0, right = 1, top = 0, bottom = 1;
  std::int64_t first_step = 0, last_step = 0;  ///< at the left and at the right end
  double time_step = 0;                        ///< [s]
  PlotRange range;                             ///< of values

  double x(std::int64_t step) const;
  /// Values beyond the range are at its ends.
  double y(double value) const;
  /// The step that is nearest to a place.
  std::int64_t step_at(double x) const;
  /// A column for each pixel.
  PlotSpan span() const;
};

/// Curves of one unit, which share an axis.
struct PlotStrip {
  std::string unit;
  std::vector<const RunCurve*> curves;
};

/// A strip for each unit, in the order of the curves.
std::vector<PlotStrip> plot_strips(const RunCurves& curves);

/// Puts the series into the first free slot, or takes it out. Nothing changes where all slots are taken.
void toggle_series(PlotChoice& chosen, const std::string& key);
/// How many slots are taken.
std::size_t count_series(const PlotChoice& chosen);

}  // namespace griffith::ui
