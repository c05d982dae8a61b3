#include "ui/model/commands.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cctype>

namespace griffith::ui {
namespace {

constexpr std::array<CommandInfo, 30> kRegistry = {{
    {CommandId::toggle_run, "simulation.run", "Run", "Run or pause", {key::kSpace}, "Space"},
    {CommandId::step, "simulation.step", "Step", "Pause and advance by one time step", {'N'}, "N"},
    {CommandId::step_back,
     "time.back",
     "Step back",
     "Go back by one time step; what was recorded comes again, to the bit",
     {key::kLeft},
     "Left"},
    {CommandId::go_to_start, "time.start", "Go to start", "Go back to the start of the recorded past", {}, ""},
    {CommandId::go_to_end, "time.end", "Go to end", "Go to the newest step of the branch", {}, ""},
    {CommandId::go_to_step, "time.step", "Go to step", "Go to a step of the recorded past", {}, ""},
    {CommandId::go_to_branch, "time.branch", "Go to branch", "Go to the end of another branch", {}, ""},
    {CommandId::explain_holding,
     "time.holding",
     "What would have held it?",
     "How much stronger the material would have to be for this node to stand: by making the step again and again",
     {},
     ""},
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

}  // namespace

std::span<const CommandInfo> command_registry() { return kRegistry; }

const CommandInfo& command_info(CommandId id) {
  const auto found = std::find_if(kRegistry.begin(), kRegistry.end(), [id](const auto& info) { return info.id == id; });
  assert(found != kRegistry.end());
  return *found;
}

}  // namespace griffith::ui
