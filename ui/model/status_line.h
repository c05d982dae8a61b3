#pragma once

#include "ui/model/editor_state.h"

namespace griffith::ui {

/// Returns the newest message that is still valid, or nullptr: the text of the status bar.
const LogLine* status_line(const EditorState& state);

}  // namespace griffith::ui
