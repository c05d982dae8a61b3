#pragma once

#include "ui/model/editor_state.h"

namespace griffith::ui {

/// The newest message that is still true, or nullptr: what the status bar shows.
const LogLine* status_line(const EditorState& state);

}  // namespace griffith::ui
