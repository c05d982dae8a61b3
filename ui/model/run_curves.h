#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace griffith::ui {

/// How many series are plotted at once, each in a colour of its own.
inline constexpr std::size_t kMaxPlotted = 6;

/// A quantity that has a value in every step.
struct RunSeries {
  std::string key;    ///< "energy.kinetic", "pieces", "probe.tip.velocity.x"
  std::string group;  ///< under which lists show it: "Energy"
  std::string label;  ///< "Kinetic"
  std::string unit;   ///< of a number that counts nothing: "J", "-" for a ratio; else empty
};

/// A series that is plotted.
struct RunCurve {
  RunSeries series;
  std::size_t slot = 0;        ///< of PlotChoice, which gives the colour
  std::vector<double> values;  ///< [series.unit], one a recorded step
};

/// What was recorded of the chosen series on the way to the end of the shown branch.
struct RunCurves {
  std::vector<std::int64_t> steps;  ///< ascending
  std::vector<double> times;        ///< of them [s]
  std::vector<RunCurve> curves;     ///< by slot
};

/// The keys of the plotted series; an empty slot is free. Keys that a scene lacks plot nothing.
using PlotChoice = std::array<std::string, kMaxPlotted>;

/// The series of the node that is selected, whichever it is.
inline constexpr char kNodeUtilization[] = "node.utilization";

/// Steps from the first to the last, both included.
struct StepSpan {
  std::int64_t first = 0, last = 0;
  bool operator==(const StepSpan&) const = default;
};

/// What the panel of plots shows, besides what Preferences say.
struct PlotsState {
  bool shown = false;
  std::optional<StepSpan> zoom;  ///< the steps that are shown; none: all
  bool for_picture = false;      ///< all strips are to be seen, and nothing that follows the mouse
  float height = 0;              ///< of the panel [pixels]; 0: not laid out yet
};

}  // namespace griffith::ui
