#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "ui/model/plot_columns.h"
#include "ui/model/run_curves.h"

namespace griffith::ui {

/// Values at the lower and upper end of a plot.
struct PlotRange {
  double low = 0, high = 1;
};

/// Returns a range of all finite values with a margin; includes 0 if it is near. Never empty.
PlotRange plot_range(std::span<const RunCurve* const> curves);
/// Returns the whole decades that contain all positive values, at most the uppermost twelve. Never empty.
PlotRange decade_range(std::span<const RunCurve* const> curves);
/// Returns the powers of ten within whole decades, every n-th so that there are at most about `count`; the lowest is
/// always included.
std::vector<double> decade_ticks(const PlotRange& range, double count);

/// Mapping of steps and values to pixels of a plot, rightward and downward.
struct PlotView {
  double left = 0, right = 1, top = 0, bottom = 1;
  std::int64_t first_step = 0, last_step = 0;  ///< steps at the left and right end
  double time_step = 0;                        ///< [s]
  PlotRange range;                             ///< range of values
  bool logarithmic = false;                    ///< logarithmic axis; the range is then positive

  double x(std::int64_t step) const;
  /// Returns the vertical position of a value; values beyond the range map to its ends.
  double y(double value) const;
  /// Returns the lowest value that is drawn.
  double floor() const;
  /// Returns the step nearest to a horizontal position.
  std::int64_t step_at(double x) const;
  /// Returns the span of time with a column for each pixel.
  PlotSpan span() const;
};

/// Curves of one unit with a common axis.
struct PlotStrip {
  std::string unit;
  std::vector<const RunCurve*> curves;
  std::span<const double> times;  ///< times of the values [s]
};

/// Groups the curves by unit, in their order. The curves must outlive the result.
std::vector<PlotStrip> plot_strips(const RunCurves& curves);

/// Returns the parts of the curves within a span of steps.
RunCurves part_of(const RunCurves& curves, const StepSpan& steps);
/// Returns a span with `factor` times as many steps in which the step `fixed` keeps its position; at least a few steps,
/// and within `whole`.
StepSpan zoomed(const StepSpan& shown, const StepSpan& whole, std::int64_t fixed, double factor);
/// Returns the span moved by so many steps, kept within `whole`.
StepSpan moved(const StepSpan& shown, const StepSpan& whole, std::int64_t steps);

/// Puts the series into the first slot that is free or holds a missing series, or removes it. Does nothing if all slots
/// are taken.
void toggle_series(PlotChoice& chosen, const std::string& key, std::span<const RunSeries> there);
/// Returns the number of slots whose series exists.
std::size_t count_series(const PlotChoice& chosen, std::span<const RunSeries> there);

}  // namespace griffith::ui
