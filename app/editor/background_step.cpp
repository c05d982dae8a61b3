#include "app/editor/background_step.h"

#include <cassert>
#include <utility>

#include "sim/core/low_priority.h"

namespace griffith::app {
namespace {

BackgroundStep::Made make(NextStep next, std::optional<StepPicture> picture) {
  const LowPriority background;
  BackgroundStep::Made made{make_step(std::move(next)), std::move(picture)};
  if (made.picture) made.picture->draw(made.step.world.frame());
  return made;
}

}  // namespace

void BackgroundStep::begin(NextStep next, std::optional<StepPicture> picture, const Start& start) {
  assert(!pending() && "one step at a time");
  start_ = start;
  begun_ = Clock::now();
  result_ = std::async(std::launch::async, make, std::move(next), std::move(picture));
}

bool BackgroundStep::wait_until(Clock::time_point deadline) const {
  return pending() && result_.wait_until(deadline) == std::future_status::ready;
}

double BackgroundStep::age() const {
  if (!pending() || wait_until(Clock::time_point::min())) return 0;
  return std::chrono::duration<double>(Clock::now() - begun_).count();
}

}  // namespace griffith::app
