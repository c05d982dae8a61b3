#include "ui/model/commands.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <vector>

#include "ui/model/command_tables.h"

namespace griffith::ui {

std::span<const CommandInfo> command_registry() {
  static const std::vector<CommandInfo> registry = [] {
    std::vector<CommandInfo> all(scene_commands().begin(), scene_commands().end());
    all.insert(all.end(), run_commands().begin(), run_commands().end());
    return all;
  }();
  return registry;
}

const CommandInfo* find_command(std::string_view name) {
  const std::span<const CommandInfo> registry = command_registry();
  const auto found = std::ranges::find(registry, name, &CommandInfo::name);
  return found == registry.end() ? nullptr : &*found;
}

const CommandInfo& command_info(CommandId id) {
  const std::span<const CommandInfo> registry = command_registry();
  const auto found = std::ranges::find(registry, id, &CommandInfo::id);
  assert(found != registry.end());
  return *found;
}

const char* menu_label(Menu menu) {
  constexpr std::array kLabels = {"", "File", "Edit", "Add", "Simulation", "View", "Help"};
  return kLabels[static_cast<std::size_t>(menu)];
}

}  // namespace griffith::ui
