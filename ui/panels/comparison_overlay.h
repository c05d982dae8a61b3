#pragma once

#include "ui/widgets/panel.h"

namespace griffith::ui {

/// Draws the compared branch over the picture in the view, right of a border that can be dragged or as a ghost, with
/// the names of both branches and their difference.
void draw_comparison(Panel& panel);

}  // namespace griffith::ui
