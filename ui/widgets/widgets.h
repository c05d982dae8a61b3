#pragma once

#include <span>
#include <string>
#include <string_view>

#include "sim/scene/field.h"
#include "ui/widgets/bubble.h"
#include "ui/widgets/icons.h"
#include "ui/widgets/panel.h"
#include "ui/widgets/style.h"

namespace griffith::ui {

/// Effect of a widget on its value in this frame.
struct Edit {
  bool changed = false;   ///< the value changed
  bool finished = false;  ///< the gesture ended: mouse released, text entered
};

/// Pixels per design pixel, from the current font.
float ui_scale(const Panel& panel);

/// Returns `text`, truncated with "…" to `width` [pixels] in the current font.
std::string fitted(std::string_view text, float width);

/// Draws a panel's heading with a thin line under it.
void heading(const Panel& panel, const char* text);

/// Begins a row "label: widget" of a panel: the next widget fills the rest of the row, or the next row if the label is
/// too long. Labels are tagged "label/<text>".
void row_label(const Panel& panel, const char* label, ImU32 color = palette::kTextDim);

/// Draws a label with a row of its own.
void wide_row_label(const Panel& panel, const char* label, ImU32 color = palette::kTextDim);

/// Draws a row "label: value" of plain text, tagged "value/<label>".
void value_row(const Panel& panel, const char* label, const std::string& value, ImU32 color);
/// Draws such a row with another tag.
void value_row(const Panel& panel, const char* tag, const char* label, const std::string& value, ImU32 color);

/// Returns the text with line ends in place of spaces, so that lines are at most so wide [pixels] in the current font.
/// Longer words stay whole. ImGui would break numbers, too, after their points.
std::string broken_into_lines(std::string_view text, float width);
/// Draws a text that wraps at spaces.
void wrapped_text(std::string_view text, ImU32 color = palette::kText);

/// Draws a small gray text that wraps.
void hint(const Panel& panel, const std::string& text);

/// Shows the note or tooltip of the last item, or scrolls to it if it is sought. The note on the last edit of the field
/// `tag` is always shown, `text` while the mouse rests on the item.
void field_tooltip(const Panel& panel, std::string_view tag, std::string_view text);

/// Closes the current list or menu one frame after Escape was pressed, so that the dialog around it sees that the key
/// was meant for the list. While text is typed, the key belongs to the text.
void close_on_escape();

/// Begins the list of a combo box, up to ImGui::EndCombo(), if it is open; Escape closes it.
bool begin_combo(const char* item, const char* preview);

/// Draws a button for a registered command, tagged "command/<name>"; grayed out while the command is disabled.
void command_button(Panel& panel, std::string_view name, Icon icon, bool with_label, bool lit = false);

/// Draws an entry for a command in the current menu, tagged with the prefix and the command's name.
void command_menu_item(Panel& panel, const CommandInfo& info, const char* tag_prefix);

/// Draws a drop-down list over the full row. Returns the index chosen in this frame or -1. Entries are tagged
/// "<tag>/<text>".
int combo_row(Panel& panel, const char* tag, const char* label, std::span<const std::string> entries,
              std::string_view shown);

/// Draws a check box with its label. True if it was toggled.
bool checkbox(Panel& panel, const char* tag, const char* label, bool& value);

/// Draws a plain button over the full width, or as wide as its text. True if it was clicked.
bool text_button(Panel& panel, const char* tag, const char* label, float width = 0);

}  // namespace griffith::ui
