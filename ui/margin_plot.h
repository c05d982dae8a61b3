#pragma once

#include "ui/editor_state.h"

namespace griffith::ui {

/// Draws the past of a margin over the full width: its limit 1 as a line, breaks as dots.
void draw_margin_plot(Panel& panel, std::span<const MarginSample> samples);

/// A bar that is full at the limit.
void draw_margin_bar(Panel& panel, double margin);

}  // namespace griffith::ui
