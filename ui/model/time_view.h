#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace griffith::ui {

/// Events of a step, as a tick on the timeline.
struct TimeTick {
  std::int64_t step = 0;
  int cracks = 0, impacts = 0;
  bool alarm = false;  ///< a solve without convergence, or values that are not finite
};

/// The recorded past, as the timeline shows it.
struct TimeView {
  std::int64_t first_step = 0, last_step = 0;  ///< range of the branch, including the past of its parents
  double time_step = 0;                        ///< [s]
  int branch = 0;
  struct BranchView {
    int parent = -1;
    std::int64_t first_step = 0, last_step = 0;
  };
  std::vector<BranchView> branches;
  std::vector<TimeTick> ticks;  ///< ticks of the branch by step
};

/// Describes a step: "step 12, 0.2 s".
std::string step_text(const TimeView& time, std::int64_t step);

/// Conditions that stop the simulation in the state before the step in which they become true.
struct Breakpoints {
  enum class Where { nowhere, anywhere, body, node };
  Where crack = Where::nowhere;  ///< next crack: any, in the selected scene body, or at the selected node
  bool on_utilization = false;
  double utilization = 0.9;  ///< limit that some node exceeds
  bool on_pieces = false;
  int pieces = 10;  ///< least number of pieces
  bool on_energy = false;
  double energy = 0.01;     ///< energy that a step leaves unaccounted for, relative to its turnover
  bool on_failure = false;  ///< a solve without convergence, or values that are not finite

  bool any() const { return crack != Where::nowhere || on_utilization || on_pieces || on_energy || on_failure; }
};

}  // namespace griffith::ui
