#include "app/editor/background_step.h"

#include <cassert>
#include <utility>

namespace griffith::app {

void BackgroundStep::begin(World world, const Start& start) {
  assert(!pending() && "one step at a time");
  start_ = start;
  begun_ = Clock::now();
  const auto step = [](World next) {
    next.step();
    return next;
  };
  result_ = std::async(std::launch::async, step, std::move(world));
}

bool BackgroundStep::wait_until(Clock::time_point deadline) const {
  return pending() && result_.wait_until(deadline) == std::future_status::ready;
}

double BackgroundStep::age() const {
  if (!pending() || wait_until(Clock::time_point::min())) return 0;
  return std::chrono::duration<double>(Clock::now() - begun_).count();
}

}  // namespace griffith::app
