#include "ui/dialogs/dialog_window.h"
#include "ui/dialogs/dialogs.h"
#include "ui/widgets/number_field.h"
#include "ui/widgets/widgets.h"

namespace griffith::ui {
namespace {

void preference_row(Panel& panel, const char* tag, const char* label, const Numbers& numbers, double& value) {
  number_field_row(panel, {.tag = tag, .label = label, .numbers = numbers}, value);
}

/// Applies the size when the mouse is released: during the drag the field would move away from the cursor.
void scale_row(Panel& panel) {
  EditorState& state = panel.state;
  if (state.dragged_scale == 0) state.dragged_scale = state.preferences.ui_scale;
  preference_row(panel, "preferences/ui_scale", "Interface scale", kUiScales, state.dragged_scale);
  if (!ImGui::IsAnyItemActive()) state.preferences.ui_scale = state.dragged_scale;
}

}  // namespace

void draw_preferences_dialog(Panel& panel) {
  EditorState& state = panel.state;
  Preferences& preferences = state.preferences;
  if (!begin_dialog(panel, "Preferences", state.show_preferences, 420)) return;
  scale_row(panel);
  preference_row(panel, "preferences/mouse_speed", "Mouse speed", kMouseSpeeds, preferences.mouse_speed);
  preference_row(panel, "preferences/autosave", "Autosave interval", kAutosaveIntervals, preferences.autosave_interval);
  preference_row(panel, "preferences/past_memory", "Memory for history", kPastMemories, preferences.past_memory);
  tooltip("With more memory, fewer steps are recomputed to go back in time.");
  preference_row(panel, "preferences/microstep_memory", "Memory for microsteps", kMicrostepMemories,
                 preferences.microstep_memory);
  tooltip("With more memory, more microsteps of an impact are recorded for playback.");
  checkbox(panel, "preferences/invert_orbit", "Invert vertical orbit", preferences.invert_orbit);
  checkbox(panel, "preferences/invert_zoom", "Invert wheel zoom", preferences.invert_zoom);
  ImGui::Spacing();
  const float width = 120 * ui_scale(panel);
  if (text_button(panel, "preferences/close", "Close", width) || escape_pressed()) state.show_preferences = false;
  ImGui::SameLine();
  if (text_button(panel, "preferences/defaults", "Defaults", width)) {
    preferences = {};
    state.dragged_scale = preferences.ui_scale;
    reset_layout(state);
  }
  if (!state.show_preferences) ImGui::CloseCurrentPopup();
  ImGui::EndPopup();
}

}  // namespace griffith::ui
