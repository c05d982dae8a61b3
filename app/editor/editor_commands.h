#pragma once

#include <span>
#include <string_view>

#include "ui/model/command_context.h"

namespace griffith::app {

class Editor;

/// A command of the editor and its action. Menus, palette, help, shortcuts, scripts and macros follow from it.
struct EditorCommand {
  ui::CommandInfo info;
  void (*carry_out)(Editor& editor, const ui::Command& command);
};

// The commands by subject, in the order of menus and help.
std::span<const EditorCommand> file_commands();
std::span<const EditorCommand> edit_commands();
std::span<const EditorCommand> arrange_commands();
std::span<const EditorCommand> macro_commands();
std::span<const EditorCommand> run_commands();
std::span<const EditorCommand> view_commands();

/// Returns the descriptions of all commands, in that order.
std::span<const ui::CommandInfo> command_registry();
/// Returns the command of that name, which must exist.
const ui::CommandInfo& command_info(std::string_view name);
/// Carries out the command, which must exist. Throws InputError if that fails.
void carry_out(Editor& editor, const ui::Command& command);

// For entries of commands.

/// Returns the reason unless the command is possible.
inline std::string_view unless(bool possible, std::string_view reason) {
  return possible ? std::string_view() : reason;
}
inline void toggle(bool& value) { value = !value; }

}  // namespace griffith::app
