#pragma once

#include "ui/widgets/panel.h"

namespace griffith::ui {

/// Draws the past of a utilization over the full width: its limit 1 as a line, breaks as dots.
void draw_utilization_plot(Panel& panel, std::span<const UtilizationSample> samples);

/// Draws a bar that is full at the limit.
void draw_utilization_bar(Panel& panel, double utilization);

}  // namespace griffith::ui
