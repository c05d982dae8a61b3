#pragma once

#include "ui/widgets/panel.h"

namespace griffith::ui {

// Each function draws its content into the current ImGui window, edits through panel.history and panel.state, and
// issues commands for everything else.

/// Draws the menus.
void draw_menu_bar(Panel& panel);
/// Draws run, pause, step, reset, slow motion and time.
void draw_toolbar(Panel& panel);
/// Draws the parts of the scene, or the pieces of its bodies, with their state, to be selected, renamed and hidden.
void draw_outliner_panel(Panel& panel);
/// Draws the fields of the active entry; for a body its material and other fields.
void draw_entry_panel(Panel& panel);
/// Draws the scene's fields besides its entries and the view.
void draw_scene_panel(Panel& panel);
/// Draws the material of the selected body; edits take effect in the running simulation at once.
void draw_material_panel(Panel& panel);
/// Draws the settings of the projectile tool.
void draw_projectile_panel(Panel& panel);
/// Draws the settings of the grab while its tool is on.
void draw_grab_panel(Panel& panel);
/// Draws the impulse of a push while its tool is on.
void draw_push_panel(Panel& panel);
/// Draws the materials that can be dragged onto bodies.
void draw_material_list(Panel& panel);
/// Draws the settings of the handles while they are shown.
void draw_handles_panel(Panel& panel);
/// Draws the settings of the picture: quantity, range and colors, element style, slice, layers.
void draw_view_panel(Panel& panel);
/// Explains the picked symbol of a layer, if there is one: a crack plane, a contact, a principal axis.
void draw_symbol_panel(Panel& panel);
/// Explains why the picked node broke or holds, and describes its element and piece.
void draw_inspector_panel(Panel& panel);
/// Draws counts, solver statistics, times by phase and problems.
void draw_statistics_panel(Panel& panel);
/// Draws the picture with camera and projectile control, legend and hints.
void draw_viewport(Panel& panel);
/// Draws the recorded microsteps, for playback. They must be shown.
void draw_microstep_bar(Panel& panel);
/// Draws the recorded past, for going back, and the stop conditions.
void draw_time_bar(Panel& panel);
/// Draws the chosen series over time; a click or a drag goes to a step.
void draw_plot_panel(Panel& panel);
/// Draws all messages, by level and text.
void draw_log_panel(Panel& panel);
/// Draws the problems of the scene; a click goes to the field.
void draw_problem_panel(Panel& panel);
/// Counts problems: "2 problems".
std::string problem_count_text(std::span<const SceneProblem> problems);
/// Returns the color of messages of a level.
ImU32 level_color(LogLevel level);
/// Draws the text of a script next to the widget to which it refers, with buttons to continue or end.
void draw_caption(Panel& panel);
/// Draws the last message.
void draw_status_bar(Panel& panel);

}  // namespace griffith::ui
