#pragma once

#include "ui/widgets/panel.h"

namespace griffith::ui {

inline constexpr ImGuiWindowFlags kDialogFlags = ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                                                 ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoSavedSettings |
                                                 ImGuiWindowFlags_AlwaysAutoResize;

/// Modal dialogs. At most one is open, and it takes all input.
enum class Dialog {
  none,
  work,
  error,
  large_mesh,
  report,
  recovery,
  replacement,
  save_as,
  unsaved,
  surface,
  scenes,
  open,
  preferences,
  steps,
  array,
  render,
  palette,
  help
};

/// Returns the dialog that is open.
Dialog shown_dialog(const EditorState& state);

/// Opens the popup when `requested` and centers it. True while its content is to be drawn, up to ImGui::EndPopup().
bool begin_dialog(const Panel& panel, const char* title, bool requested, float design_width);

/// True if Escape was pressed and no list or text field of the dialog takes it.
bool escape_pressed();

/// True if Enter or Escape was pressed in a dialog that only reports.
bool dismiss_pressed();

/// True if Escape has just left the text field drawn last with nothing typed in it: the key then closes the dialog.
bool escape_left_untyped();

}  // namespace griffith::ui
