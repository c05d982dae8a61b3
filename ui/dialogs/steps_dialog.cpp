#include "ui/dialogs/dialog_window.h"
#include "ui/dialogs/dialogs.h"
#include "ui/widgets/number_field.h"

namespace griffith::ui {

void draw_steps_dialog(Panel& panel) {
  constexpr Numbers kCounts = between(1, kMaxAskedSteps, "");
  std::optional<int>& count = panel.state.asked_steps;
  if (!begin_dialog(panel, "Advance by steps", count.has_value(), 420)) return;
  number_field_row(panel, {.tag = "steps/count", .label = "Steps", .numbers = kCounts}, *count);
  hint(panel, "As fast as possible; Space stops early.");
  ImGui::Spacing();
  const float width = 120 * ui_scale(panel);
  const bool made = text_button(panel, "steps/make", "Advance", width) ||
                    (ImGui::IsKeyPressed(key::kEnter, false) && panel.state.field_note.tag.empty());
  ImGui::SameLine();
  const bool cancelled = text_button(panel, "steps/cancel", "Cancel", width) || escape_pressed();
  if (made) issue(panel, {.name = "simulation.make_steps", .step = *count});
  if (made || cancelled) {
    count.reset();
    ImGui::CloseCurrentPopup();
  }
  ImGui::EndPopup();
}

}  // namespace griffith::ui
