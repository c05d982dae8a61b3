#pragma once

#include "ui/widgets/panel.h"

namespace griffith::ui {

/// Lets the mouse move and turn what is chosen, where the state shows the gizmo and the world stands at its start: with
/// an arrow or plane all that is chosen moves, a ring turns the last of it.
/// To be called behind the item that the picture fills. Whether the mouse is the gizmo's: it means nothing else then.
bool drag_gizmo(Panel& panel);

/// Draws it over the picture.
void draw_gizmo(Panel& panel);

}  // namespace griffith::ui
