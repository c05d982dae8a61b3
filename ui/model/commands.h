#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "sim/core/linear_algebra.h"
#include "ui/model/shortcut.h"

namespace griffith::ui {

/// Everything that a user can ask for besides editing values.
enum class CommandId {
  toggle_run,
  step,
  ask_steps,
  make_steps,
  step_back,
  go_to_start,
  go_to_end,
  go_to_step,
  go_to_branch,
  explain_holding,
  toggle_comparison,
  reset,
  fire,
  keep_shot,
  pick,
  new_scene,
  open_dialog,
  browse_scenes,
  open,
  add_box,
  add_plate,
  add_pane,
  add_cylinder,
  add_sphere,
  add_beam,
  add_support,
  add_load,
  add_projectile,
  add_camera,
  add_probe,
  duplicate,
  remove,
  move_up,
  move_down,
  rename,
  toggle_hidden,
  look_through,
  set_camera,
  toggle_gizmo,
  toggle_painting,
  add_surface_dialog,
  add_surface,
  save,
  save_dialog,
  save_recording_dialog,
  save_recording,
  save_report_dialog,
  save_report,
  save_plots_dialog,
  save_plots,
  record_macro,
  save_macro_dialog,
  save_macro,
  play_macro,
  export_dialog,
  export_run,
  recover,
  discard_copy,
  leave_copy,
  undo,
  redo,
  frame_all,
  toggle_edges,
  toggle_range_lock,
  toggle_slice,
  select_most_loaded,
  screenshot,
  preferences,
  toggle_plots,
  palette,
  log,
  toggle_problems,
  tour,
  help,
  quit,
};

/// A request, carried out by the program after the panels are drawn.
struct Command {
  CommandId id;
  /// open: the scene; save and others that write: where, or empty for the scene's own file; their dialogs: proposed
  std::filesystem::path path = {};
  std::int64_t step = 0;         ///< go_to_step, go_to_branch; make_steps: how many
  int branch = 0;                ///< go_to_branch
  Vec2 cursor = Vec2(0.5, 0.5);  ///< fire, pick: place in the view, from its top left corner, 0..1
  bool discard_edits = false;    ///< new_scene, open, quit: even where edits are not saved
  bool replace = false;          ///< what writes: even where that loses what another has written
};

/// How many steps can be asked for at once.
inline constexpr int kMaxAskedSteps = 1'000'000;

/// Where a menu shows a command. Commands that are in no menu are issued by widgets and scripts alone.
enum class Menu { none, file, edit, add, simulation, view, help };

/// What a script writes behind a command's name.
enum class CommandArgument { none, path, step, branch_and_step, cursor };

struct CommandContext;

/// A command as menus, buttons, shortcuts, palette, help, scripts and tests know it.
struct CommandInfo {
  CommandId id;
  std::string_view name;   ///< "simulation.step"
  std::string_view label;  ///< "Step"
  std::string_view hint;   ///< one line for tooltips and help
  Menu menu = Menu::none;
  int group = 0;  ///< of the menu; a line parts it from the next
  Shortcut shortcut = {};
  /// Why the command makes no sense now; empty: it does. Null: it always does.
  std::string_view (*why_not)(const CommandContext& context) = nullptr;
  /// Whether what the command toggles is on. Null: it toggles nothing.
  bool (*is_on)(const CommandContext& context) = nullptr;
  CommandArgument argument = CommandArgument::none;
  /// What a script means that gives the command the file for which it would ask in a dialog.
  std::optional<CommandId> with_path = std::nullopt;
};

/// All commands, in the order in which menus and help show them.
std::span<const CommandInfo> command_registry();
const CommandInfo& command_info(CommandId id);
/// The command of that name, or nullptr.
const CommandInfo* find_command(std::string_view name);
/// "File".
const char* menu_label(Menu menu);

}  // namespace griffith::ui
