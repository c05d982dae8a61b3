#pragma once

#include "ui/widgets/panel.h"

namespace griffith::ui {

/// Draws the side panels at both ends of a rectangle [pixels]. Their inner borders can be dragged; their sections can
/// be dragged by the grip that appears at the right end of a title, to another place or side, and folded by a click on
/// it.
void draw_side_panels(Panel& panel, ImVec2 corner, ImVec2 end);

}  // namespace griffith::ui
