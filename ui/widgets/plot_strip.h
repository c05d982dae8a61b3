#pragma once

#include "ui/model/plot_view.h"
#include "ui/widgets/panel.h"

namespace griffith::ui {

/// Returns the color of a slot of PlotChoice.
ImU32 plot_color(std::size_t slot);

/// Returns the steps that plots show.
StepSpan shown_steps(const Panel& panel);

/// Draws the curves of a unit over the full width, `height` [pixels] high, with the numbers of their axis, their names,
/// the current step and the one under the mouse. Returns the mapping to pixels. The item has the tag `tag`. `compared`:
/// the same curves of another branch, drawn paler behind them; may be null.
PlotView draw_plot_strip(Panel& panel, const std::string& tag, const PlotStrip& strip, const PlotStrip* compared,
                         float height);

/// Draws the numbers of the time axis below strips, over the full width.
void draw_plot_times(Panel& panel);
/// Returns their height [pixels].
float plot_times_height(const Panel& panel);

}  // namespace griffith::ui
