#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string_view>

#include "sim/core/linear_algebra.h"
#include "ui/model/shortcut.h"

namespace griffith::ui {

/// A request, carried out by the program after the panels are drawn.
struct Command {
  std::string_view name;  ///< as in its CommandInfo; the text must live as long as the program
  /// file.open_path: the scene. Commands that write: the file, or empty for the scene's own. Their dialogs: the
  /// proposed file.
  std::filesystem::path path = {};
  std::int64_t step = 0;         ///< time.step, time.branch: target step; simulation.make_steps: number of steps
  int branch = 0;                ///< time.branch
  Vec3 offset = Vec3::Zero();    ///< edit.make_array: from each copy to the next [m]; their number is `step`
  Vec2 cursor = Vec2(0.5, 0.5);  ///< simulation.fire, view.pick: point of the viewport, from its top left corner, 0..1
  bool discard_edits = false;    ///< commands that leave the scene: discards unsaved edits
  bool replace = false;          ///< commands that write: replaces a file of another program
  bool pack_outside = false;     ///< commands that write recordings: packs files from outside the scene's folder, too
};

/// Largest number of steps for simulation.make_steps.
inline constexpr int kMaxAskedSteps = 1'000'000;
/// Largest number of equal bodies for edit.make_array.
inline constexpr int kMaxArray = 1000;

/// Menu that lists a command; `none` for commands of widgets and scripts alone.
enum class Menu { none, file, edit, add, simulation, view, help };

/// Argument that a script gives after a command's name.
enum class CommandArgument { none, path, step, branch_and_step, cursor, array };

struct CommandContext;

/// Description of a command, from which menus, buttons, shortcuts, palette, help, scripts and tests are made.
struct CommandInfo {
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
  /// Name of the command that takes the file, or the number and offset, for which the dialog of this one asks.
  std::string_view with_path = {};
  /// Action that discards unsaved edits: "Quitting"; empty if the command keeps them.
  std::string_view leaves = {};
  bool repeats = false;      ///< repeats while its key is held
  bool in_dialogs = false;   ///< its key also works in dialogs and text fields
  bool recorded = true;      ///< macros record it, unless it opens a dialog ("…")
  bool for_pictures = true;  ///< pictures of the editor may show its result: it does not read or write files, or quit
};

/// Returns the command of that name, or nullptr.
const CommandInfo* find_command(std::span<const CommandInfo> commands, std::string_view name);
/// Returns the title of a menu: "File".
const char* menu_label(Menu menu);

}  // namespace griffith::ui
