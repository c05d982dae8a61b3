#pragma once

#include <limits>
#include <span>
#include <vector>

namespace griffith::ui {

/// What a column of pixels of a plot holds of a series.
struct PlotColumn {
  int column = 0;
  double first = 0, low = 0, high = 0, last = 0;
  bool begins = false;  ///< the line is broken before it, by values that can't be drawn
};

/// The times at both ends of a plot [s], and how many columns of pixels lie between.
struct PlotSpan {
  double start = 0, end = 0;
  int columns = 0;

  /// From 0 to columns - 1; times beyond the ends fall into the outermost.
  int column(double time) const;
};

/// Reduces a series to what its columns of pixels show, so that no peak is lost: the lowest and highest value of each,
/// from left to right. Columns without values are left out. `times`: ascending, as many as `values`. Values that are
/// not finite, or not above `floor`, are not drawn.
std::vector<PlotColumn> plot_columns(std::span<const double> times, std::span<const double> values,
                                     const PlotSpan& span, double floor = -std::numeric_limits<double>::infinity());

}  // namespace griffith::ui
