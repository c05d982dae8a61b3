#pragma once

#include "ui/model/plot_view.h"
#include "ui/widgets/panel.h"

namespace griffith::ui {

/// The colour of a slot of PlotChoice.
ImU32 plot_color(std::size_t slot);

/// The steps that plots show.
StepSpan shown_steps(const Panel& panel);

/// Draws the curves of a unit over the full width, `height` [pixels] high, with the numbers of their axis, their names,
/// the present step and the one at which the mouse points. Returns where things are in it. It is an item of `tag`.
/// `compared`: the same curves of another branch, drawn paler behind them; or null.
PlotView draw_plot_strip(Panel& panel, const std::string& tag, const PlotStrip& strip, const PlotStrip* compared,
                         float height);

/// Draws the numbers of time below strips, over the full width.
void draw_plot_times(Panel& panel);
/// How high they are [pixels].
float plot_times_height(const Panel& panel);

}  // namespace griffith::ui
