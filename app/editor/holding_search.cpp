#include "app/editor/holding_search.h"

#include <chrono>
#include <utility>

#include "sim/core/low_priority.h"

namespace griffith::app {

HoldingSearch::HoldingSearch(const Timeline& timeline, NodeId node) : run_(run_to_crack(timeline, node)) {
  enter("what would have held it");
  answer_ = std::async(std::launch::async, [this, before = timeline.world()] {
    const LowPriority background;
    return search(before);
  });
}

std::string HoldingSearch::stage() const {
  const std::lock_guard lock(mutex_);
  return stage_;
}

std::optional<HoldingAnswer> HoldingSearch::take() {
  if (answer_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return std::nullopt;
  return answer_.get();
}

HoldingAnswer HoldingSearch::search(const World& before) {
  const Monitor monitor{[this](std::string_view stage) { enter(stage); }, [this] { return cancelled_.load(); }};
  HoldingAnswer answer;
  try {
    answer.strength = critical_strength_factor(before, run_.scene_body, run_.node, monitor);
    answer.broken = cracks_of_step(before, run_.scene_body, run_.node, 1, monitor);
    answer.held = cracks_of_step(before, run_.scene_body, run_.node, answer.strength.holds, monitor);
    answer.speed = critical_speed_factor(run_, monitor);
    answer.thickness = critical_thickness_factor(run_, monitor);
  } catch (const Cancelled&) {
    answer.cancelled = true;
  } catch (const std::exception& error) {  // such as a lack of memory: the editor continues
    answer.problem = error.what();
  }
  return answer;
}

void HoldingSearch::enter(std::string_view stage) {
  const std::lock_guard lock(mutex_);
  stage_ = "Trying " + std::string(stage);
}

}  // namespace griffith::app
