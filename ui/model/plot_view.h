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
/// Whole decades that hold all positive values, the uppermost twelve at most. Never empty.
PlotRange decade_range(std::span<const RunCurve* const> curves);
/// The powers of ten in whole decades, every n-th so that there are about `count` at most, the lowest always.
std::vector<double> decade_ticks(const PlotRange& range, double count);

/// Where steps and values are in a plot; places are in pixels, downwards and to the right.
struct PlotView {
  double left = 0, right = 1, top = 0, bottom = 1;
  std::int64_t first_step = 0, last_step = 0;  ///< at the left and at the right end
  double time_step = 0;                        ///< [s]
  PlotRange range;                             ///< of values
  bool logarithmic = false;                    ///< equal distances are equal ratios; the range is positive then

  double x(std::int64_t step) const;
  /// Values beyond the range are at its ends.
  double y(double value) const;
  /// The lowest value that is drawn.
  double floor() const;
  /// The step that is nearest to a place.
  std::int64_t step_at(double x) const;
  /// A column for each pixel.
  PlotSpan span() const;
};

/// Curves of one unit, which share an axis.
struct PlotStrip {
  std::string unit;
  std::vector<const RunCurve*> curves;
  std::span<const double> times;  ///< of their values [s]
};

/// A strip for each unit, in the order of the curves, which have to outlive it.
std::vector<PlotStrip> plot_strips(const RunCurves& curves);

/// What of the curves lies in some steps.
RunCurves part_of(const RunCurves& curves, const StepSpan& steps);
/// Shows `factor` times as many steps as before, one of which stays where it is; a few at least, and none beyond the
/// `whole`.
StepSpan zoomed(const StepSpan& shown, const StepSpan& whole, std::int64_t fixed, double factor);
/// As many steps, so many further on, as far as the `whole` has them.
StepSpan moved(const StepSpan& shown, const StepSpan& whole, std::int64_t steps);

/// Puts the series into the first slot that is free or has a series that is not there, or takes it out. Nothing changes
/// where all slots are taken.
void toggle_series(PlotChoice& chosen, const std::string& key, std::span<const RunSeries> there);
/// How many slots have a series that is there.
std::size_t count_series(const PlotChoice& chosen, std::span<const RunSeries> there);

}  // namespace griffith::ui
