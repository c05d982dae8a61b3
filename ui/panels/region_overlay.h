#pragma once

#include "ui/widgets/panel.h"

namespace griffith::ui {

// The region of the chosen support, load or probe, at the start of the scene's time: a scene says where it is then.

/// Lets the mouse drag the faces of a box and the surface of a sphere. To be called behind the item that the picture
/// fills. Whether the mouse is the region's: it means nothing else then.
bool drag_region(Panel& panel);

/// Draws its outline over the picture, with what can be dragged.
void draw_region(Panel& panel);

}  // namespace griffith::ui
