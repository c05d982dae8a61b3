#include "ui/dialogs/dialog_window.h"
#include "ui/dialogs/dialogs.h"
#include "ui/widgets/field_range.h"
#include "ui/widgets/number_field.h"

namespace griffith::ui {
namespace {

void offset_rows(Panel& panel, Vec3& offset) {
  constexpr const char *kTags[] = {"array/x", "array/y", "array/z"}, *kLabels[] = {"Offset x", "Offset y", "Offset z"};
  const Numbers range = range_of<BodyDescription>("position");
  for (int axis = 0; axis < 3; ++axis)
    number_field_row(panel, {.tag = kTags[axis], .label = kLabels[axis], .numbers = range}, offset[axis]);
}

}  // namespace

void draw_array_dialog(Panel& panel) {
  constexpr Numbers kCounts = between(2, kMaxArray, "");
  std::optional<ArrayRequest>& request = panel.state.array;
  if (!begin_dialog(panel, "Array", request.has_value(), 420)) return;
  number_field_row(panel, {.tag = "array/count", .label = "Number", .numbers = kCounts}, request->count);
  offset_rows(panel, request->offset);
  hint(panel, "From each one to the next; at first they stand side by side.");
  ImGui::Spacing();
  const float width = 120 * ui_scale(panel);
  const bool made = text_button(panel, "array/make", "Repeat", width) ||
                    (ImGui::IsKeyPressed(key::kEnter, false) && panel.state.field_note.tag.empty());
  ImGui::SameLine();
  const bool cancelled = text_button(panel, "array/cancel", "Cancel", width) || escape_pressed();
  if (made) issue(panel, {.name = "edit.make_array", .step = request->count, .offset = request->offset});
  if (made || cancelled) {
    request.reset();
    ImGui::CloseCurrentPopup();
  }
  ImGui::EndPopup();
}

}  // namespace griffith::ui
