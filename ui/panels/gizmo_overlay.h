#pragma once

#include "ui/widgets/panel.h"

namespace griffith::ui {

/// Lets the mouse move and rotate the selected entries if the gizmo is shown and the simulation is at its start. An
/// arrow or plane moves all of them, a ring rotates the active one. Call it after the item that the picture fills. True
/// if the gizmo takes the mouse.
bool drag_gizmo(Panel& panel);

/// Draws the gizmo over the picture.
void draw_gizmo(Panel& panel);

}  // namespace griffith::ui
