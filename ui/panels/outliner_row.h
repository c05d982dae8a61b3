#pragma once

#include <string>
#include <vector>

#include "ui/panels/outliner_rows.h"
#include "ui/widgets/panel.h"

namespace griffith::ui {

/// Draws a row of the outliner's table, its cells in the order of BodyColumn and then the eye. `rows`: all listed rows,
/// for selecting ranges with Shift.
void draw_outliner_row(Panel& panel, const std::vector<OutlinerRow>& rows, const OutlinerRow& row);

/// Selects a row as a click does: Ctrl toggles it, Shift selects the range from the active one.
void select_row(Panel& panel, const std::vector<OutlinerRow>& rows, const OutlinerRow& row);
bool is_chosen(const Panel& panel, const OutlinerRow& row);

/// Formats a mass: "17.1 t".
std::string mass_text(double mass);

}  // namespace griffith::ui
