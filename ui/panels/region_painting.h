#pragma once

#include "ui/widgets/panel.h"

namespace griffith::ui {

// The region of the chosen support, load or probe, painted on its body at the start of the scene's time.

/// Lets the mouse paint nodes, or take them off with Ctrl, while painting is on; a drag that begins beside the body
/// turns the view as ever. To be called behind the item that the picture fills. Whether the mouse is the brush's.
bool paint_region(Panel& panel);

/// Draws the nodes of a painted region over the picture, and the brush.
void draw_painted_region(Panel& panel);

}  // namespace griffith::ui
