#pragma once

#include "ui/widgets/panel.h"

namespace griffith::ui {

/// Aims while the right button is held in the view, which was drawn last. Releasing it fires, Escape cancels. `cursor`:
/// position of the mouse in the view.
void aim_shot(Panel& panel, const Vec2& cursor);

/// Draws the predicted path of the aimed shot and its hit.
void draw_aim(const Panel& panel);

}  // namespace griffith::ui
