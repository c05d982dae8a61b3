#include "ui/model/microsteps.h"

#include <cstdio>

#include "sim/core/number_text.h"

namespace griffith::ui {

int microsteps_of(const Frame& frame, const Scene& scene) {
  if (frame.step == 0 || scene.simulation.integrator != Integrator::explicit_) return frame.report.microsteps;
  return frame.report.substeps;
}

std::string moment_text(const MicrostepView& view, int moment) {
  const double time = view.moments[static_cast<std::size_t>(moment)].time, since = time - view.moments.front().time;
  char text[64];
  std::snprintf(text, sizeof text, "%+.2f µs", 1e6 * since);
  return text;
}

std::string microstep_text(const MicrostepView& view, int moment) {
  return "microstep " + count_text(view.moments[static_cast<std::size_t>(moment)].microstep) + " of " +
         count_text(view.microsteps) + " in step " + std::to_string(view.step);
}

std::string recording_text(const MicrostepView& view) {
  constexpr double kMegabyte = 1 << 20;
  const std::string every =
      view.interval == 1 ? "each microstep" : "every " + count_text(view.interval) + " microsteps";
  char memory[64];
  std::snprintf(memory, sizeof memory, ", %.0f of %.0f MB", static_cast<double>(view.memory) / kMegabyte,
                static_cast<double>(view.memory_limit) / kMegabyte);
  return count_text(static_cast<long long>(view.moments.size())) + " moments, " + every + memory;
}

}  // namespace griffith::ui
