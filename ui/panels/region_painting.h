#pragma once

#include "ui/widgets/panel.h"

namespace griffith::ui {

// Region of the active support, load or probe, painted on its body at the start of the simulation.

/// Lets the mouse paint nodes, or erase them with Ctrl, while painting is on; a drag that begins off the body rotates
/// the view as usual. Call it after the item that the picture fills. True if the brush takes the mouse.
bool paint_region(Panel& panel);

/// Draws the nodes of a painted region over the picture, and the brush.
void draw_painted_region(Panel& panel);

}  // namespace griffith::ui
