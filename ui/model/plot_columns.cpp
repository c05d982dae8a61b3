#include "ui/model/plot_columns.h"

#include <algorithm>
#include <cmath>

namespace griffith::ui {

int PlotSpan::column(double time) const {
  const double length = end - start;
  if (!(length > 0)) return 0;
  return static_cast<int>(std::clamp((time - start) / length * columns, 0.0, std::max(0.0, columns - 1.0)));
}

std::vector<PlotColumn> plot_columns(std::span<const double> times, std::span<const double> values,
                                     const PlotSpan& span, double floor) {
  std::vector<PlotColumn> columns;
  bool begins = true;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double value = values[i];
    if (!std::isfinite(value) || value <= floor) {
      begins = true;
      continue;
    }
    const int column = span.column(times[i]);
    if (columns.empty() || columns.back().column != column)
      columns.push_back({column, value, value, value, value, begins});
    PlotColumn& last = columns.back();
    last.low = std::min(last.low, value);
    last.high = std::max(last.high, value);
    last.last = value;
    begins = false;
  }
  return columns;
}

}  // namespace griffith::ui
