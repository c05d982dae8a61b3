#include "ui/widgets/panel.h"

#include <stdexcept>
#include <string>
#include <utility>

#include "ui/model/command_context.h"

namespace griffith::ui {
namespace {

CommandContext context_of(const Panel& panel) {
  const Frame& frame = panel.input.frame;
  return {panel.state,
          panel.history,
          panel.input.time,
          frame.step,
          panel.input.views.front().legend.has_value(),
          microsteps_of(frame, panel.history.scene())};
}

}  // namespace

std::string_view disabled_reason(const CommandInfo& info, const Panel& panel) {
  return info.disabled_reason ? info.disabled_reason(context_of(panel)) : std::string_view();
}

bool is_on(const CommandInfo& info, const Panel& panel) { return info.is_on && info.is_on(context_of(panel)); }

bool command_enabled(const CommandInfo& info, const Panel& panel) { return disabled_reason(info, panel).empty(); }

const CommandInfo& command_info(std::string_view name, const Panel& panel) {
  const CommandInfo* info = find_command(panel.input.commands, name);
  if (!info) throw std::logic_error("there is no command " + std::string(name));
  return *info;
}

void issue(Panel& panel, Command command) { panel.commands.push_back(std::move(command)); }

}  // namespace griffith::ui
