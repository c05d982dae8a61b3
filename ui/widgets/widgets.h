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

/// What a widget did to its value in this frame.
struct Edit {
  bool changed = false;   ///< the value is another one now
  bool finished = false;  ///< the gesture ended: mouse released, text entered
};

/// Pixels per design pixel, from the font in use.
float ui_scale(const Panel& panel);

/// `text`, or as much of its beginning as is `width` [pixels] wide with "…" behind it, in the font in use.
std::string fitted(std::string_view text, float width);

/// A panel's heading with a thin line under it.
void heading(const Panel& panel, const char* text);

/// Begins a row "label: widget" of a panel: label on the left, the next widget fills the rest; below a label that is
/// too long for that. Labels are tagged "label/<text>".
void row_label(const Panel& panel, const char* label, ImU32 color = palette::kTextDim);

/// A label with a line of its own.
void wide_row_label(const Panel& panel, const char* label, ImU32 color = palette::kTextDim);

/// A row "label: value" of plain text.
void value_row(const Panel& panel, const char* label, const std::string& value, ImU32 color);

/// A small grey line that wraps.
void hint(const Panel& panel, const std::string& text);

/// Shows what there is to say of the last item, or scrolls to it where it is sought: beside it the note on the last
/// edit, where that was one of the field `tag`, else `text` while the mouse rests on it.
void field_tooltip(const Panel& panel, std::string_view tag, std::string_view text);

/// Closes the list or menu that is being drawn, a frame after Escape was pressed: so long the dialog around it sees
/// that the key was meant for something within. Where a text was being typed, the key was meant for that.
void close_on_escape();

/// Begins the list of a combo, up to ImGui::EndCombo(), where it is open; Escape closes it.
bool begin_combo(const char* item, const char* preview);

/// A button for a registered command, tagged "command/<name>"; greyed when the command makes no sense now.
void command_button(Panel& panel, CommandId id, Icon icon, bool with_label, bool lit = false);

/// An entry for a command in the menu that is being drawn, tagged with the prefix and the command's name.
void command_menu_item(Panel& panel, const CommandInfo& info, const char* tag_prefix);

/// A drop-down list over the full row. Returns the index chosen in this frame or -1. Entries are tagged "<tag>/<text>".
int combo_row(Panel& panel, const char* tag, const char* label, std::span<const std::string> entries,
              std::string_view shown);

/// A check box with its label. True when it was toggled.
bool checkbox(Panel& panel, const char* tag, const char* label, bool& value);

/// A plain button over the full width, or as wide as its text. True when clicked.
bool text_button(Panel& panel, const char* tag, const char* label, float width = 0);

}  // namespace griffith::ui
