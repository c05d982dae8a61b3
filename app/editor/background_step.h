#pragma once

#include <chrono>
#include <cstdint>
#include <future>
#include <optional>

#include "app/editor/step_picture.h"
#include "sim/timeline/timeline.h"

namespace griffith::app {

/// Makes a time step of a copy of the world on a thread of its own, so that the window goes on living meanwhile, and
/// what follows from the step: what the timeline keeps of it, its picture. What else happens to the world while the
/// step is being made makes it stale: it is thrown away then, and so the result depends on no clock.
class BackgroundStep {
 public:
  using Clock = std::chrono::steady_clock;

  /// What a step begins with: equal starts, equal worlds.
  struct Start {
    std::int64_t world = -1, revision = -1;
    bool operator==(const Start&) const = default;
  };

  struct Made {
    MadeStep step;
    std::optional<StepPicture> picture;  ///< where one was asked for
  };

  /// Begins a step. None may be on its way.
  void begin(NextStep next, std::optional<StepPicture> picture, const Start& start);
  /// Whether a step is on its way or lies there to be taken.
  bool pending() const { return result_.valid(); }
  /// Whether that step is the next one of what is there now.
  bool fits(const Start& now) const { return pending() && start_ == now; }
  /// Waits until then at most; whether the step is made.
  bool wait_until(Clock::time_point deadline) const;
  /// How long the step has been under way [s]; 0 when none is.
  double age() const;
  /// The step, once it is made: waits for it. One must be pending. Throws what the step threw.
  Made take() { return result_.get(); }

 private:
  std::future<Made> result_;
  Start start_;
  Clock::time_point begun_;
};

}  // namespace griffith::app
