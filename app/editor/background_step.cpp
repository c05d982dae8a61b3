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
  std::packaged_task<Made(NextStep, std::optional<StepPicture>)> task(make);
  result_ = task.get_future();
  thread_ = std::jthread(
      [task = std::move(task), done = done_, next = std::move(next), picture = std::move(picture)]() mutable {
        task(std::move(next), std::move(picture));
        if (done) done();
      });
}

bool BackgroundStep::wait_until(Clock::time_point deadline) const {
  return pending() && result_.wait_until(deadline) == std::future_status::ready;
}

double BackgroundStep::age() const {
  if (!in_progress()) return 0;
  return std::chrono::duration<double>(Clock::now() - begun_).count();
}

}  // namespace griffith::app
