#include "app/editor/editor_commands.h"

#include <stdexcept>
#include <string>
#include <vector>

namespace griffith::app {
namespace {

const std::vector<EditorCommand>& all_commands() {
  static const std::vector<EditorCommand> commands = [] {
    std::vector<EditorCommand> all;
    for (const auto part :
         {file_commands(), edit_commands(), arrange_commands(), macro_commands(), run_commands(), view_commands()})
      all.insert(all.end(), part.begin(), part.end());
    return all;
  }();
  return commands;
}

}  // namespace

std::span<const ui::CommandInfo> command_registry() {
  static const std::vector<ui::CommandInfo> infos = [] {
    std::vector<ui::CommandInfo> all;
    for (const EditorCommand& command : all_commands()) all.push_back(command.info);
    return all;
  }();
  return infos;
}

const ui::CommandInfo& command_info(std::string_view name) {
  const ui::CommandInfo* info = ui::find_command(command_registry(), name);
  if (!info) throw std::logic_error("there is no command " + std::string(name));
  return *info;
}

void carry_out(Editor& editor, const ui::Command& command) {
  const auto index = &command_info(command.name) - command_registry().data();
  all_commands()[static_cast<std::size_t>(index)].carry_out(editor, command);
}

}  // namespace griffith::app
