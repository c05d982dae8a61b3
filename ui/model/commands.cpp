#include "ui/model/commands.h"

#include <algorithm>
#include <array>

namespace griffith::ui {

const CommandInfo* find_command(std::span<const CommandInfo> commands, std::string_view name) {
  const auto found = std::ranges::find(commands, name, &CommandInfo::name);
  return found == commands.end() ? nullptr : &*found;
}

const char* menu_label(Menu menu) {
  constexpr std::array kLabels = {"", "File", "Edit", "Add", "Simulation", "View", "Help"};
  return kLabels[static_cast<std::size_t>(menu)];
}

}  // namespace griffith::ui
