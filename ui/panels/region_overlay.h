#pragma once

#include "ui/widgets/panel.h"

namespace griffith::ui {

// Region of the active support, load or probe, at the start of the simulation, for which scenes define it.

/// Lets the mouse drag the faces of a box and the surface of a sphere. Call it after the item that the picture fills.
/// True if the region takes the mouse.
bool drag_region(Panel& panel);

/// Draws the outline of the region over the picture, with its grips.
void draw_region(Panel& panel);

}  // namespace griffith::ui
