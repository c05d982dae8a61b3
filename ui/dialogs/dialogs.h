#pragma once

#include "ui/dialogs/dialogs.h"
#include "ui/widgets/panel.h"

namespace griffith::ui {

// Each draws its window where it is due.

/// Help, open and error windows, where wanted.
void draw_dialogs(Panel& panel);
/// Asks where the scene is to be saved.
void draw_save_dialog(Panel& panel);
/// Asks whether a file may be replaced.
void draw_replacement_dialog(Panel& panel);
/// Asks what is to become of edits that are not saved.
void draw_unsaved_dialog(Panel& panel);
/// Asks what is to become of edits that were cut short.
void draw_left_edits_dialog(Panel& panel);
/// Asks for a surface file and how to fill it.
void draw_surface_dialog(Panel& panel);
/// What is kept from one start to the next.
void draw_preferences_dialog(Panel& panel);
/// Shows pictures of scenes to open.
void draw_scenes_dialog(Panel& panel);
/// Asks how many steps are to be made.
void draw_steps_dialog(Panel& panel);
/// Finds a command by letters of its name.
void draw_palette_dialog(Panel& panel);
/// Asks whether a mesh of many tetrahedra is meant.
void draw_large_mesh_dialog(Panel& panel);
/// Tells what came of it.
void draw_report_dialog(Panel& panel);

}  // namespace griffith::ui
