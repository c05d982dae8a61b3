#include <string>
#include <vector>

#include "ui/model/units.h"
#include "ui/model/verdict.h"
#include "ui/panels/overlays.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace griffith::ui {
namespace {

/// A limit of the shown result, and what the user can do about it.
struct ViewWarning {
  const char* tag;
  std::string text, remedy;
  ImU32 color = palette::kWarning;
};

/// Adds whether bodies are computed as a softer material now. Those that broke so have a label in the picture.
void add_scaling(const Frame& frame, std::vector<ViewWarning>& warnings) {
  const BodyView* least = nullptr;
  for (const BodyView& body : frame.bodies)
    if (body.scaled && (!least || body.scaled->factor < least->scaled->factor)) least = &body;
  if (least)
    warnings.push_back(
        {"view/scaled", "Computed at " + scale_text(*least->scaled), stand_in_text(*least->scaled), palette::kWarning});
}

void add_failures(const Frame& frame, double size, std::vector<ViewWarning>& warnings) {
  constexpr double kDeep = 0.01;  // of the size of all bodies
  const StepReport& report = frame.report;
  if (report.non_finite_values > 0)
    warnings.push_back({"view/not_finite", "Values not finite: bodies are frozen",
                        "Shorten the time step, or set less stiffness. Go back to repeat the step.", palette::kError});
  if (const int failed = report.unconverged_solves + report.unconverged_motions + report.unconverged_contacts)
    warnings.push_back({"view/unconverged", std::to_string(failed) + " not converged in this step",
                        "Solves, large motions or contacts ended before their tolerance. Shorten the time step, or "
                        "allow more solver iterations (panel Scene).",
                        palette::kWarning});
  if (report.max_penetration > kDeep * size)
    warnings.push_back({"view/overlap", "Overlap of " + format_quantity(report.max_penetration, "m", 2),
                        "Bodies have sunk into each other. Shorten the time step, or move bodies apart that overlap at "
                        "the start (View > Problems).",
                        palette::kWarning});
}

}  // namespace

void draw_view_warnings(Panel& panel, ImVec2 corner) {
  std::vector<ViewWarning> warnings;
  add_scaling(panel.input.frame, warnings);
  add_failures(panel.input.frame, (panel.input.high - panel.input.low).norm(), warnings);
  const float scale = ui_scale(panel), margin = 14 * scale, padding = 12 * scale, height = 30 * scale;
  ImVec2 low = {corner.x + margin, corner.y + margin + height + 8 * scale};  // below the mark of a pause
  for (const ViewWarning& warning : warnings) {
    const ImVec2 high = {low.x + ImGui::CalcTextSize(warning.text.c_str()).x + 2 * padding, low.y + height};
    draw_card(ImGui::GetWindowDrawList(), low, high, scale);
    ImGui::SetCursorScreenPos({low.x + padding, (low.y + high.y - ImGui::GetFontSize()) / 2});
    ImGui::TextColored(as_vec4(warning.color), "%s", warning.text.c_str());
    tag_last_item(panel.tags, warning.tag, warning.text);
    tooltip(warning.remedy);
    low.y = high.y + 6 * scale;
  }
}

}  // namespace griffith::ui
