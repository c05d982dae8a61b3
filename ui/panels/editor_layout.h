#pragma once

#include "ui/widgets/panel.h"

namespace griffith::ui {

/// Draws the editor into the current ImGui frame, between NewFrame and Render. Edits change `history` and `state`;
/// everything else is returned as commands, to be carried out in order. `tags` receives the widgets of this frame.
std::vector<Command> draw_editor(const EditorInput& input, EditorState& state, EditHistory& history, WidgetTags& tags);

}  // namespace griffith::ui
