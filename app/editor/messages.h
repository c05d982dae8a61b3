#pragma once

#include <filesystem>
#include <string>

#include "sim/core/error.h"
#include "ui/model/editor_state.h"

namespace griffith::app {

/// Appends a message to the log, which keeps the last 5000.
void log_message(ui::EditorState& state, ui::LogLevel level, std::string text, ui::LogSpan span = ui::LogSpan::lasting);

/// Stops the simulation, discards the queued commands and shows the error.
void show_error(ui::EditorState& state, const InputError& error);

/// Discards commands queued during work that failed, with a message for each.
void discard_queued_commands(ui::EditorState& state);

/// True if the command may write its file. Else it asks whether `in_the_way` may be replaced.
bool may_replace(ui::EditorState& state, const ui::Command& command, const std::filesystem::path& in_the_way);

}  // namespace griffith::app
