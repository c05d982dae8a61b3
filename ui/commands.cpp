#include "ui/commands.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cctype>

#include "ui/dialog_window.h"

namespace griffith::ui {
namespace {

constexpr std::array<CommandInfo, 24> kRegistry = {{
    {CommandId::toggle_run, "simulation.run", "Run", "Run or pause", {key::kSpace}, "Space"},
    {CommandId::step, "simulation.step", "Step", "Pause and advance by one time step", {'N'}, "N"},
    {CommandId::reset, "simulation.reset", "Reset", "Start again from the scene as it is now edited", {'R'}, "R"},
    {CommandId::fire,
     "simulation.fire",
     "Fire",
     "Fire the projectile at the cursor; right click in the view",
     {'F'},
     "F"},
    {CommandId::pick, "view.pick", "Pick", "Inspect the element under the cursor; left click in the view", {}, ""},
    {CommandId::frame_all,
     "view.frame_all",
     "Frame all",
     "Bring everything into the picture, but for shards that flew far",
     {key::kHome},
     "Home"},
    {CommandId::toggle_edges, "view.edges", "Element edges", "Show or hide the edges of the elements", {'E'}, "E"},
    {CommandId::toggle_range_lock,
     "view.lock_range",
     "Lock colour range",
     "Keep the colour range as it is now, or let it follow the values",
     {'L'},
     "L"},
    {CommandId::toggle_slice,
     "view.slice",
     "Slice",
     "Cut the bodies open across the line of sight; Ctrl+drag moves the cut",
     {'X'},
     "X"},
    {CommandId::select_most_loaded,
     "view.select_most_loaded",
     "Most loaded node",
     "Inspect the node that is nearest to breaking",
     {'M'},
     "M"},
    {CommandId::undo, "edit.undo", "Undo", "Take the last edit of the scene back", {'Z', true}, "Ctrl+Z"},
    {CommandId::redo, "edit.redo", "Redo", "Do the edit again that was taken back", {'Z', true, true}, "Ctrl+Shift+Z"},
    {CommandId::open_dialog,
     "file.open",
     "Open…",
     "Open a scene; dropping a file on the window does the same",
     {'O', true},
     "Ctrl+O"},
    {CommandId::open, "file.open_path", "Open scene", "Open the scene with the given path", {}, ""},
    {CommandId::add_surface_dialog,
     "file.add_surface",
     "Add a body from a surface…",
     "Fill a surface file with tetrahedra and add it to the scene",
     {},
     ""},
    {CommandId::add_surface, "file.fill_surface", "Fill surface", "Fill the surface of the dialog", {}, ""},
    {CommandId::save, "file.save", "Save", "Write the scene as it is now edited and shown", {'S', true}, "Ctrl+S"},
    {CommandId::save_dialog,
     "file.save_as",
     "Save as…",
     "Write the scene to another file, which it is then edited in",
     {'S', true, true},
     "Ctrl+Shift+S"},
    {CommandId::recover, "file.recover", "Recover", "Take up edits that were cut short", {}, ""},
    {CommandId::discard_copy,
     "file.discard_copy",
     "Discard copy",
     "Delete the copy of edits that were cut short",
     {},
     ""},
    {CommandId::leave_copy, "file.leave_copy", "Leave copy", "Ask again at the next start", {}, ""},
    {CommandId::screenshot,
     "file.screenshot",
     "Screenshot",
     "Save the window as a PNG file in the working folder",
     {key::kF12},
     "F12"},
    {CommandId::help, "help.show", "Help", "Show or hide mouse and keyboard help", {key::kF1}, "F1"},
    {CommandId::quit, "file.quit", "Quit", "Leave the program", {'Q', true}, "Ctrl+Q"},
}};

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

std::span<const CommandInfo> command_registry() { return kRegistry; }

const CommandInfo& command_info(CommandId id) {
  const auto found = std::find_if(kRegistry.begin(), kRegistry.end(), [id](const auto& info) { return info.id == id; });
  assert(found != kRegistry.end());
  return *found;
}

bool command_enabled(CommandId id, const Panel& panel) {
  switch (id) {
    case CommandId::undo:
      return panel.history.can_undo();
    case CommandId::redo:
      return panel.history.can_redo();
    case CommandId::recover:
    case CommandId::discard_copy:
    case CommandId::leave_copy:
      return !panel.state.left_edits.empty();
    case CommandId::toggle_range_lock:
      return panel.state.view.range.has_value() || panel.input.legend.has_value();
    default:
      return true;
  }
}

void issue(Panel& panel, Command command) {
  if (command_enabled(command.id, panel)) panel.commands.push_back(std::move(command));
}

void issue_shortcuts(Panel& panel) {
  const bool typing = ImGui::GetIO().WantTextInput;
  const Vec2 cursor = cursor_place(panel.state);
  const Dialog dialog = shown_dialog(panel.state);
  for (const CommandInfo& info : kRegistry) {
    if (passes(info.id, dialog, typing) && shortcut_pressed(info.shortcut))
      issue(panel, {.id = info.id, .cursor = cursor});
  }
}

}  // namespace griffith::ui
