#include "ui/panels/shortcuts.h"

#include "ui/dialogs/dialog_window.h"

namespace griffith::ui {
namespace {

/// True if the command's shortcut was pressed. `may_repeat`: allows repetition of a held key, if the command repeats.
bool shortcut_pressed(const CommandInfo& info, bool may_repeat) {
  const ImGuiIO& io = ImGui::GetIO();
  const Shortcut& shortcut = info.shortcut;
  return shortcut.key != key::kNone && io.KeyCtrl == shortcut.ctrl && io.KeyShift == shortcut.shift &&
         io.KeyAlt == shortcut.alt && ImGui::IsKeyPressed(shortcut.key, may_repeat && info.repeats);
}

/// Issues a command of a shortcut. A dialog or text field blocks all but those that do not affect the scene; the key of
/// the help also closes it. During work, commands are queued in order, up to a click that was lost: what is typed after
/// it was meant for what was clicked.
void take_order(Panel& panel, const CommandInfo& info, const Command& command, Dialog dialog, bool waits) {
  if (info.in_dialogs) return issue(panel, command);
  if (ImGui::GetIO().WantTextInput) return;
  if (dialog == Dialog::work && panel.state.lost_click) return;
  if (waits && (dialog == Dialog::work || dialog == Dialog::none)) return panel.state.waiting.push_back(command);
  if (dialog == Dialog::none || (dialog == Dialog::help && info.name == "help.show")) issue(panel, command);
}

/// Issues one queued command per drawn frame: its work may delay the next one.
void issue_waiting(Panel& panel) {
  std::vector<Command>& waiting = panel.state.waiting;
  if (waiting.empty()) return;
  issue(panel, waiting.front());
  waiting.erase(waiting.begin());
}

/// Returns true if the mouse has clicked beside the dialog of the work, now or before while it is open.
bool has_lost_click(const EditorState& state, Dialog dialog) {
  const bool clicks =
      ImGui::IsMouseClicked(ImGuiMouseButton_Left) && !ImGui::IsWindowHovered(ImGuiHoveredFlags_AnyWindow);
  return dialog == Dialog::work && (state.lost_click || clicks);
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
  const Vec2 cursor = cursor_place(panel.state);
  const Dialog dialog = shown_dialog(panel.state);
  const bool waits = dialog == Dialog::work || !panel.state.waiting.empty();
  panel.state.lost_click = has_lost_click(panel.state, dialog);
  if (dialog == Dialog::none) issue_waiting(panel);
  for (const CommandInfo& info : panel.input.commands)
    if (shortcut_pressed(info, !waits)) take_order(panel, info, {.name = info.name, .cursor = cursor}, dialog, waits);
}

}  // namespace griffith::ui
