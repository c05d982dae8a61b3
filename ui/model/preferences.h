#pragma once

#include "sim/scene/field.h"
#include "ui/model/run_curves.h"
#include "ui/model/section_order.h"

namespace griffith::ui {

/// Settings of a user for all scenes.
struct Preferences {
  double ui_scale = 1;                         ///< size of panels and text, relative to the screen's scale
  double autosave_interval = 60;               ///< interval between copies of unsaved edits [s]
  double mouse_speed = 1;                      ///< speed of rotating and moving the camera
  bool invert_orbit = false;                   ///< dragging up rotates down
  bool invert_zoom = false;                    ///< reverses the wheel
  double left_width = 300, right_width = 300;  ///< widths of the side panels [design pixels]
  PlotChoice plotted = {"energy.kinetic", "energy.elastic", "pieces"};
  bool logarithmic_plots = false;            ///< logarithmic axes of plots
  double past_memory = 768;                  ///< memory for snapshots, which make going back fast [MB]
  double microstep_memory = 512;             ///< memory for the recorded microsteps of a step [MB]
  bool show_left = true, show_right = true;  ///< shows the side panels
  double plots_height = 0, log_height = 0, problems_height = 0;  ///< [design pixels]; 0: automatic
  SectionOrder sections;

  bool operator==(const Preferences&) const = default;
};

inline constexpr Numbers kUiScales = between(0.75, 3, "-"), kAutosaveIntervals = between(5, 3600, "s"),
                         kMouseSpeeds = between(0.1, 5, "-"), kSideWidths = between(240, 520, ""),
                         kDockHeights = between(0, 4000, ""), kPastMemories = between(32, 65536, "MB"),
                         kMicrostepMemories = between(32, 65536, "MB");

/// Calls `visit(name, member, limits)` for each number and `visit(name, member)` for each switch, the choice of plots
/// and the sections.
template <typename P, typename Visit>
void each_preference(P& preferences, const Visit& visit) {
  visit("ui_scale", preferences.ui_scale, kUiScales);
  visit("autosave_interval", preferences.autosave_interval, kAutosaveIntervals);
  visit("mouse_speed", preferences.mouse_speed, kMouseSpeeds);
  visit("past_memory", preferences.past_memory, kPastMemories);
  visit("microstep_memory", preferences.microstep_memory, kMicrostepMemories);
  visit("left_width", preferences.left_width, kSideWidths);
  visit("right_width", preferences.right_width, kSideWidths);
  visit("invert_orbit", preferences.invert_orbit);
  visit("invert_zoom", preferences.invert_zoom);
  visit("plotted", preferences.plotted);
  visit("logarithmic_plots", preferences.logarithmic_plots);
  visit("show_left", preferences.show_left);
  visit("show_right", preferences.show_right);
  visit("plots_height", preferences.plots_height, kDockHeights);
  visit("log_height", preferences.log_height, kDockHeights);
  visit("problems_height", preferences.problems_height, kDockHeights);
  visit("sections", preferences.sections);
}

}  // namespace griffith::ui
