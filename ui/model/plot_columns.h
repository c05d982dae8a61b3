#pragma once

#include <limits>
#include <span>
#include <vector>

namespace griffith::ui {

/// Values of a series within one column of pixels.
struct PlotColumn {
  int column = 0;
  double first = 0, low = 0, high = 0, last = 0;
  bool begins = false;  ///< true if values that cannot be drawn precede it, so that the line is interrupted
};

/// Times at both ends of a plot [s] and the number of pixel columns between.
struct PlotSpan {
  double start = 0, end = 0;
  int columns = 0;

  /// Returns the column of a time, 0..columns - 1; times beyond the ends map to the outermost columns.
  int column(double time) const;
};

/// Reduces a series to the lowest and highest value of each column of pixels, from left to right, so that no peak is
/// lost. Columns without values are omitted. `times`: ascending, as many as `values`. Values that are not finite, or
/// not above `floor`, are not drawn.
std::vector<PlotColumn> plot_columns(std::span<const double> times, std::span<const double> values,
                                     const PlotSpan& span, double floor = -std::numeric_limits<double>::infinity());

}  // namespace griffith::ui
