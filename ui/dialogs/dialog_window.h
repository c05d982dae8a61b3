#pragma once

#include "ui/widgets/panel.h"

namespace griffith::ui {

inline constexpr ImGuiWindowFlags kDialogFlags = ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                                                 ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoSavedSettings |
                                                 ImGuiWindowFlags_AlwaysAutoResize;

/// One at a time is shown, and nothing else takes orders meanwhile.
enum class Dialog {
  none,
  work,
  error,
  large_mesh,
  report,
  left_edits,
  replacement,
  save_as,
  unsaved,
  surface,
  scenes,
  open,
  preferences,
  steps,
  palette,
  help
};

/// The one that is due.
Dialog shown_dialog(const EditorState& state);

/// Opens the popup when `wanted` and centres it. True while its content is to be drawn, up to ImGui::EndPopup().
bool begin_dialog(const Panel& panel, const char* title, bool wanted, float design_width);

/// Whether Escape was pressed, and not for a list or a text field of the dialog.
bool escape_pressed();

/// Whether Escape has just left the text field drawn last, with nothing typed in it: the key then means the dialog.
bool escape_left_untyped();

}  // namespace griffith::ui
