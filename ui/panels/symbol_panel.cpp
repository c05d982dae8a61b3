#include "ui/model/symbol.h"
#include "ui/panels/overlays.h"
#include "ui/panels/panels.h"
#include "ui/panels/view_drawing.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace griffith::ui {
namespace {

/// Returns the time over which the contacts of the frame acted [s]: a step, or the part of it before a microstep.
double contact_time(const EditorInput& input) {
  if (!input.microsteps) return input.time_step;
  return input.frame.time - static_cast<double>(input.frame.step) * input.time_step;
}

}  // namespace

void draw_symbol_panel(Panel& panel) {
  if (!panel.state.symbol) return;
  const EditorInput& input = panel.input;
  const std::optional<SymbolReport> report =
      symbol_report(*panel.state.symbol, input.frame, panel.history.scene(), contact_time(input));
  if (!report) return;
  heading(panel, report->title.c_str());
  wrapped_text(report->sentence);
  tag_last_item(panel.tags, "symbol/sentence", report->sentence);
  for (const SymbolReport::Row& row : report->rows)
    value_row(panel, ("symbol/" + row.label).c_str(), row.label.c_str(), row.value, palette::kText);
}

void draw_symbol(const Panel& panel) {
  draw_world_lines(panel, ImGui::GetWindowDrawList(), panel.input.symbol_lines, Pose{}, kHeldColor);
}

}  // namespace griffith::ui
