#pragma once

#include "ui/widgets/panel.h"

namespace griffith::ui {

/// Draws the whole editor into the current ImGui frame (between NewFrame and Render). Edits go into `history` and
/// `state`, everything else comes back as commands, to be carried out in order. `tags` gets the widgets of this frame.
std::vector<Command> draw_editor(const EditorInput& input, EditorState& state, EditHistory& history, WidgetTags& tags);

}  // namespace griffith::ui
