#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <future>
#include <optional>
#include <thread>
#include <utility>

#include "app/editor/step_picture.h"
#include "sim/timeline/timeline.h"

namespace griffith::app {

/// Makes a time step of a copy of the world on a thread of its own, so that the window stays responsive, together with
/// its snapshot and picture. Any other change of the world during the step makes it stale. A stale step is discarded,
/// so the result does not depend on timing.
class BackgroundStep {
 public:
  using Clock = std::chrono::steady_clock;

  /// Starting point of a step; equal values mean equal worlds.
  struct Start {
    std::int64_t world = -1, revision = -1;
    bool operator==(const Start&) const = default;
  };

  struct Made {
    MadeStep step;
    std::optional<StepPicture> picture;  ///< picture, if requested
  };

  /// Sets a function to be called on that thread at the end of each step.
  void call_when_done(std::function<void()> done) { done_ = std::move(done); }
  /// Begins a step. None may be in progress.
  void begin(NextStep next, std::optional<StepPicture> picture, const Start& start);
  /// True if a step is in progress or finished but not taken.
  bool pending() const { return result_.valid(); }
  /// True if that step follows from the current world.
  bool fits(const Start& now) const { return pending() && start_ == now; }
  /// Waits no longer than `deadline`. True if the step is finished.
  bool wait_until(Clock::time_point deadline) const;
  /// True if a step is in progress and not finished.
  bool in_progress() const { return pending() && !wait_until(Clock::time_point::min()); }
  /// Returns the time since the step began [s]; 0 if there is none.
  double age() const;
  /// Waits for the step and returns it. One must be pending. Rethrows an exception of the step.
  Made take() { return result_.get(); }

 private:
  std::future<Made> result_;
  std::function<void()> done_;
  Start start_;
  Clock::time_point begun_;
  std::jthread thread_;  ///< ends before the data
};

}  // namespace griffith::app
