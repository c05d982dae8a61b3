#include "ui/dialogs/dialog_window.h"

#include <cfloat>

#include "ui/widgets/widgets.h"

namespace griffith::ui {

Dialog shown_dialog(const EditorState& state) {
  if (!state.work.empty()) return Dialog::work;
  if (state.error) return Dialog::error;
  if (state.large_mesh) return Dialog::large_mesh;
  if (state.report) return Dialog::report;
  if (!state.recoverable_edits.empty()) return Dialog::recovery;
  if (state.replacement) return Dialog::replacement;
  if (state.save_as) return Dialog::save_as;
  if (state.unsaved) return Dialog::unsaved;
  if (state.show_surface) return Dialog::surface;
  if (state.browser.shown) return Dialog::scenes;
  if (state.show_open) return Dialog::open;
  if (state.show_preferences) return Dialog::preferences;
  if (state.asked_steps) return Dialog::steps;
  if (state.array) return Dialog::array;
  if (state.render.shown) return Dialog::render;
  if (state.palette.shown) return Dialog::palette;
  return state.show_help ? Dialog::help : Dialog::none;
}

bool begin_dialog(const Panel& panel, const char* title, bool requested, float design_width) {
  const float scale = ui_scale(panel), width = design_width * scale;
  if (requested && !ImGui::IsPopupOpen(title)) ImGui::OpenPopup(title);
  const ImVec2 center = ImGui::GetMainViewport()->GetCenter();
  ImGui::SetNextWindowPos(center, ImGuiCond_Always, {0.5f, 0.5f});
  ImGui::SetNextWindowSizeConstraints({width, 0}, {width, FLT_MAX});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 8 * scale);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, scale);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {20 * scale, 14 * scale});
  const bool open = ImGui::BeginPopupModal(title, nullptr, kDialogFlags);
  ImGui::PopStyleVar(3);
  if (open) heading(panel, title);
  return open;
}

bool escape_pressed() {
  const bool list_is_open = ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId), types = ImGui::GetIO().WantTextInput;
  return ImGui::IsKeyPressed(key::kEscape, false) && !list_is_open && !types;
}

bool dismiss_pressed() { return ImGui::IsKeyPressed(key::kEnter, false) || escape_pressed(); }

bool escape_left_untyped() {
  return ImGui::IsKeyPressed(key::kEscape, false) && ImGui::IsItemDeactivated() && !ImGui::IsItemDeactivatedAfterEdit();
}

}  // namespace griffith::ui
