#pragma once

#include "ui/widgets/panel.h"

namespace griffith::ui {

/// Holding the right button in the view, which was drawn last, aims; letting it go fires, Escape gives up. `cursor`:
/// place of the mouse in the view.
void aim_shot(Panel& panel, const Vec2& cursor);

/// The arc of the shot that is being aimed, and where it hits.
void draw_aim(const Panel& panel);

}  // namespace griffith::ui
