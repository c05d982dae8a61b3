#include "app/editor/messages.h"

#include <utility>

#include "app/editor/editor_commands.h"
#include "app/shared/scene_files.h"
#include "sim/core/replace_file.h"

namespace griffith::app {

void log_message(ui::EditorState& state, ui::LogLevel level, std::string text, ui::LogSpan span) {
  constexpr std::size_t kMaxLines = 5000;
  if (state.log.size() >= kMaxLines) {
    state.log.erase(state.log.begin());
    for (std::size_t* older : {&state.log_seen, &state.log_passed}) *older -= *older > 0;
  }
  state.log.push_back({level, std::move(text), span});
}

void show_error(ui::EditorState& state, const InputError& error) {
  state.running = false;
  discard_queued_commands(state);
  state.error = ui::ErrorMessage{error.where(), error.problem(), error.remedy()};
  log_message(state, ui::LogLevel::error, error.what(), ui::LogSpan::action);
}

void discard_queued_commands(ui::EditorState& state) {
  for (const ui::Command& command : std::exchange(state.waiting, {}))
    log_message(state, ui::LogLevel::warning,
                std::string(command_info(command.name).label) + " was skipped: the work before it failed.");
}

bool may_replace(ui::EditorState& state, const ui::Command& command, const std::filesystem::path& in_the_way) {
  if (command.replace || !is_taken(in_the_way)) {
    check_replaceable(command.path);
    return true;
  }
  state.replacement = ui::Replacement{command, in_the_way.string() + " already exists."};
  return false;
}

}  // namespace griffith::app
