#include "ui/panels/shortcuts.h"

#include "ui/dialogs/dialog_window.h"

namespace griffith::ui {
namespace {

bool shortcut_pressed(const Shortcut& shortcut) {
  const ImGuiIO& io = ImGui::GetIO();
  const bool repeats = shortcut.key == 'N' || shortcut.key == 'Z';
  return shortcut.key != key::kNone && io.KeyCtrl == shortcut.ctrl && io.KeyShift == shortcut.shift && !io.KeyAlt &&
         ImGui::IsKeyPressed(shortcut.key, repeats);
}

/// A dialog takes all orders but those that leave the scene alone, and so does a text field; the help goes as it came.
bool passes(CommandId id, Dialog dialog, bool typing) {
  if (id == CommandId::screenshot || id == CommandId::quit) return true;
  if (typing) return false;
  return dialog == Dialog::none || (dialog == Dialog::help && id == CommandId::help);
}

bool cursor_in_view(const EditorState& state) {
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  const ImVec2 low = state.viewport_minimum, size = state.viewport_size;
  return mouse.x >= low.x && mouse.y >= low.y && mouse.x < low.x + size.x && mouse.y < low.y + size.y;
}

Vec2 cursor_place(const EditorState& state) {
  if (!cursor_in_view(state)) return {0.5, 0.5};
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  return {(mouse.x - state.viewport_minimum.x) / state.viewport_size.x,
          (mouse.y - state.viewport_minimum.y) / state.viewport_size.y};
}

}  // namespace

void issue_shortcuts(Panel& panel) {
  const bool typing = ImGui::GetIO().WantTextInput;
  const Vec2 cursor = cursor_place(panel.state);
  const Dialog dialog = shown_dialog(panel.state);
  for (const CommandInfo& info : command_registry()) {
    if (passes(info.id, dialog, typing) && shortcut_pressed(info.shortcut))
      issue(panel, {.id = info.id, .cursor = cursor});
  }
}

}  // namespace griffith::ui
