#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace griffith::ui {

/// Largest number of plotted series, each with a color of its own.
inline constexpr std::size_t kMaxPlotted = 6;

/// A quantity with a value in every step.
struct RunSeries {
  std::string key;    ///< "energy.kinetic", "pieces", "probe.tip.velocity.x"
  std::string group;  ///< heading in lists: "Energy"
  std::string label;  ///< "Kinetic"
  std::string unit;   ///< unit: "J", "-" for a ratio; empty for a count
};

/// A plotted series.
struct RunCurve {
  RunSeries series;
  std::size_t slot = 0;        ///< slot of PlotChoice, which determines the color
  std::vector<double> values;  ///< value of each recorded step [series.unit]
};

/// Recorded values of the chosen series up to the end of the shown branch.
struct RunCurves {
  std::vector<std::int64_t> steps;  ///< ascending
  std::vector<double> times;        ///< times of the steps [s]
  std::vector<RunCurve> curves;     ///< curves by slot
};

/// Keys of the plotted series; an empty slot is free. Keys that a scene lacks plot nothing.
using PlotChoice = std::array<std::string, kMaxPlotted>;

/// Key of the series of the selected node.
inline constexpr char kNodeUtilization[] = "node.utilization";

/// Range of steps, both ends included.
struct StepSpan {
  std::int64_t first = 0, last = 0;
  bool operator==(const StepSpan&) const = default;
};

/// State of the plot panel besides Preferences.
struct PlotsState {
  bool shown = false;
  std::optional<StepSpan> zoom;  ///< shown steps; none: all
  bool for_picture = false;      ///< draws all strips and nothing that follows the mouse
  float height = 0;              ///< height of the panel [pixels]; 0: not laid out yet
};

}  // namespace griffith::ui
