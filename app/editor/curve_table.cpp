#include "app/editor/curve_table.h"

#include "app/output/csv_field.h"
#include "sim/core/number_text.h"

namespace griffith::app {
namespace {

std::string curve_heading(const ui::RunSeries& series) {
  return csv_field(series.unit.empty() ? series.key : series.key + " [" + series.unit + "]");
}

}  // namespace

std::string curve_table(const ui::RunCurves& curves) {
  std::string csv = "step,time [s]";
  for (const ui::RunCurve& curve : curves.curves) csv.append(",").append(curve_heading(curve.series));
  csv += "\n";
  for (std::size_t row = 0; row < curves.steps.size(); ++row) {
    append_number(csv, curves.steps[row]);
    append_csv_number(csv, curves.times[row]);
    for (const ui::RunCurve& curve : curves.curves) append_csv_number(csv, curve.values[row]);
    csv += "\n";
  }
  return csv;
}

}  // namespace griffith::app
