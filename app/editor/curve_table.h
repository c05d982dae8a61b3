#pragma once

#include <string>

#include "ui/model/run_curves.h"

namespace griffith::app {

/// Returns curves as CSV (RFC 4180): step, time and a column for each curve, "energy.kinetic [J]", one row for each
/// recorded step. Numbers are the shortest that read back as the same double; values that are not finite are left
/// empty.
std::string curve_table(const ui::RunCurves& curves);

}  // namespace griffith::app
