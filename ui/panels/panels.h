#pragma once

#include "ui/widgets/panel.h"

namespace griffith::ui {

// Each draws its content into the current ImGui window, edits through panel.history and panel.state, and leaves the
// rest to commands.

/// File, edit, simulation and view menus.
void draw_menu_bar(Panel& panel);
/// Run, pause, step, reset, slow motion, time.
void draw_toolbar(Panel& panel);
/// All that the scene holds, or the pieces of its bodies, with their state: to be chosen, named and hidden.
void draw_outliner_panel(Panel& panel);
/// The fields of the active entry: of a body its material and what else a scene says of it.
void draw_entry_panel(Panel& panel);
/// What a scene says besides its entries and the view.
void draw_scene_panel(Panel& panel);
/// The material of the selected body; takes effect in the running simulation at once.
void draw_material_panel(Panel& panel);
/// What the projectile tool fires.
void draw_projectile_panel(Panel& panel);
/// What the picture shows: quantity, range and colours, how elements are drawn, slice, layers.
void draw_view_panel(Panel& panel);
/// Why the picked node did or did not break, and its element and piece.
void draw_inspector_panel(Panel& panel);
/// Counts, solver, time per phase and everything that went wrong.
void draw_statistics_panel(Panel& panel);
/// The picture with camera and projectile control, legend and hints.
void draw_viewport(Panel& panel);
/// The recorded past, to go back to; where the simulation is to stop by itself.
void draw_time_bar(Panel& panel);
/// How the chosen series went over time; a click or a drag goes to a step.
void draw_plot_panel(Panel& panel);
/// All messages, by level and text.
void draw_log_panel(Panel& panel);
/// What should be known about parts of the scene; a click goes to the field.
void draw_problem_panel(Panel& panel);
/// "2 problems".
std::string problem_count_text(std::span<const SceneProblem> problems);
/// The colour that messages of a level are written in.
ImU32 level_color(LogLevel level);
/// What a script says, beside the widget that it is about, with the buttons that go on or end it.
void draw_caption(Panel& panel);
/// The last message.
void draw_status_bar(Panel& panel);

}  // namespace griffith::ui
