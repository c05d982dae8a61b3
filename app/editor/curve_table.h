#pragma once

#include <string>

#include "ui/model/run_curves.h"

namespace griffith::app {

/// Curves as CSV (RFC 4180): step, time and a column a curve, "energy.kinetic [J]", one row a recorded step. Numbers
/// are the shortest that read back as the same double; what is not finite is left empty.
std::string curve_table(const ui::RunCurves& curves);

}  // namespace griffith::app
