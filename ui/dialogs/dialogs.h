#pragma once

#include "ui/dialogs/dialogs.h"
#include "ui/widgets/panel.h"

namespace griffith::ui {

// Each function draws its window while its dialog is open.

/// Draws the help, open and error windows.
void draw_dialogs(Panel& panel);
/// Asks where the scene is to be saved.
void draw_save_dialog(Panel& panel);
/// Asks whether a file may be replaced.
void draw_replacement_dialog(Panel& panel);
/// Asks whether unsaved edits are saved or discarded.
void draw_unsaved_dialog(Panel& panel);
/// Asks whether unsaved edits of a crashed run are recovered.
void draw_recovery_dialog(Panel& panel);
/// Asks for a surface file and how to fill it.
void draw_surface_dialog(Panel& panel);
/// Draws the preferences.
void draw_preferences_dialog(Panel& panel);
/// Shows pictures of scenes to open.
void draw_scenes_dialog(Panel& panel);
/// Asks for a number of steps.
void draw_steps_dialog(Panel& panel);
/// Asks for the number and distance of repeated bodies.
void draw_array_dialog(Panel& panel);
/// Asks what pictures are drawn, in which size.
void draw_render_dialog(Panel& panel);
/// Finds a command by letters of its name.
void draw_palette_dialog(Panel& panel);
/// Asks whether a very large mesh is built.
void draw_large_mesh_dialog(Panel& panel);
/// Shows the result of finished work.
void draw_report_dialog(Panel& panel);

}  // namespace griffith::ui
