#include "ui/widgets/panel.h"

#include <utility>

namespace griffith::ui {

bool command_enabled(CommandId id, const Panel& panel) {
  switch (id) {
    case CommandId::undo:
      return panel.history.can_undo();
    case CommandId::redo:
      return panel.history.can_redo();
    case CommandId::step_back:
    case CommandId::go_to_start:
      return panel.input.frame.step > panel.input.time.first_step;
    case CommandId::go_to_end:
      return panel.input.frame.step < panel.input.time.last_step;
    case CommandId::explain_holding:
      return panel.state.can_explain;
    case CommandId::keep_shot:
      return panel.state.last_shot.has_value();
    case CommandId::duplicate_body:
    case CommandId::delete_body:
      return !panel.history.scene().bodies.empty();
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

}  // namespace griffith::ui
