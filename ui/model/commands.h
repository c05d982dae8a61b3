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

/// Commands of the editor, except edits of values.
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
  /// open: the scene. Commands that write: the file, or empty for the scene's own. Their dialogs: the proposed file.
  std::filesystem::path path = {};
  std::int64_t step = 0;         ///< go_to_step, go_to_branch: target step; make_steps: number of steps
  int branch = 0;                ///< go_to_branch
  Vec2 cursor = Vec2(0.5, 0.5);  ///< fire, pick: point of the view, from its top left corner, 0..1
  bool discard_edits = false;    ///< new_scene, open, quit: discards unsaved edits
  bool replace = false;          ///< commands that write: replaces a file of another program
};

/// Largest number of steps for make_steps.
inline constexpr int kMaxAskedSteps = 1'000'000;

/// Menu that lists a command; `none` for commands of widgets and scripts alone.
enum class Menu { none, file, edit, add, simulation, view, help };

/// Argument that a script gives after a command's name.
enum class CommandArgument { none, path, step, branch_and_step, cursor };

struct CommandContext;

/// Description of a command, from which menus, buttons, shortcuts, palette, help, scripts and tests are made.
struct CommandInfo {
  CommandId id;
  std::string_view name;   ///< "simulation.step"
  std::string_view label;  ///< "Step"
  std::string_view hint;   ///< one line for tooltips and help
  Menu menu = Menu::none;
  int group = 0;  ///< group within the menu; a separator precedes each new group
  Shortcut shortcut = {};
  /// Returns the reason why the command is disabled; empty if it is enabled. Null: always enabled.
  std::string_view (*disabled_reason)(const CommandContext& context) = nullptr;
  /// True if the toggled state is on. Null: not a toggle.
  bool (*is_on)(const CommandContext& context) = nullptr;
  CommandArgument argument = CommandArgument::none;
  /// The command that a script issues when it gives a file instead of the dialog.
  std::optional<CommandId> with_path = std::nullopt;
};

/// Returns all commands in the order of menus and help.
std::span<const CommandInfo> command_registry();
const CommandInfo& command_info(CommandId id);
/// Returns the command of that name, or nullptr.
const CommandInfo* find_command(std::string_view name);
/// Returns the title of a menu: "File".
const char* menu_label(Menu menu);

}  // namespace griffith::ui
