#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace griffith::ui {

/// Something that happened in a step, as a tick on the bar of time.
struct TimeTick {
  std::int64_t step = 0;
  int cracks = 0, impacts = 0;
  bool alarm = false;  ///< a solve without convergence, or values that broke down
};

/// The recorded past, as the bar of time shows it.
struct TimeView {
  std::int64_t first_step = 0, last_step = 0;  ///< of the branch, its parents' past included
  double time_step = 0;                        ///< [s]
  int branch = 0;
  struct BranchView {
    int parent = -1;
    std::int64_t first_step = 0, last_step = 0;
  };
  std::vector<BranchView> branches;
  std::vector<TimeTick> ticks;  ///< of the branch, by step
};

/// "step 12, 0.2 s".
std::string step_text(const TimeView& time, std::int64_t step);

/// When the simulation stops by itself: in the state before the step in which one of these comes true.
struct Breakpoints {
  enum class Where { nowhere, anywhere, body, node };
  Where crack = Where::nowhere;  ///< the next crack: any, in the selected scene body, at the selected node
  bool on_utilization = false;
  double utilization = 0.9;  ///< some node's passes this
  bool on_pieces = false;
  int pieces = 10;  ///< so many there are, or more
  bool on_energy = false;
  double energy = 0.01;     ///< what a step leaves unaccounted for, of what was turned over in it
  bool on_failure = false;  ///< a solve without convergence, or values that break down

  bool any() const { return crack != Where::nowhere || on_utilization || on_pieces || on_energy || on_failure; }
};

}  // namespace griffith::ui
