// The part of RunController that goes to recorded steps.
#include <algorithm>
#include <chrono>
#include <utility>

#include "app/editor/frame_schedule.h"
#include "app/editor/messages.h"
#include "app/editor/run_controller.h"

namespace griffith::app {
namespace {

/// Throws InputError unless the step was recorded.
void require_recorded(const Timeline& timeline, int branch, std::int64_t step) {
  const auto refuse = [](const std::string& what, const std::string& kind, std::int64_t first, std::int64_t last) {
    const std::string range = " " + std::to_string(first) + (last > first ? " to " + std::to_string(last) : "");
    throw InputError(what, "was not recorded", "only " + kind + range + (last > first ? " are" : " is") + " recorded");
  };
  const auto branches = static_cast<std::int64_t>(timeline.branches().size());
  if (branch < 0 || branch >= branches)
    refuse("branch " + std::to_string(branch), branches > 1 ? "branches" : "branch", 0, branches - 1);
  const std::int64_t first = timeline.first_step(), last = timeline.branches()[branch].last_step;
  if (step < first || step > last)
    refuse("step " + std::to_string(step) + " of branch " + std::to_string(branch), last > first ? "steps" : "step",
           first, last);
}

}  // namespace

void RunController::go_to(int branch, std::int64_t step) {
  state_.running = false;
  require_recorded(timeline_, branch, step);
  approach(branch, step);
}

void RunController::go_to_nearest(std::int64_t step) {
  state_.running = false;
  approach(timeline_.branch(), step);
}

void RunController::approach(int branch, std::int64_t step, bool records) {
  close_microsteps();
  takes_recorded_step_ = records;
  document_.history().finish();
  let_go();
  if (branch != timeline_.branch()) {
    utilizations_.clear();
    if (state_.comparison.branch == branch) state_.comparison.branch = timeline_.branch();  // the two branches swap
  }
  const std::int64_t destination = timeline_.approach(branch, step);
  travel_ = {timeline_.step(), destination};
  continue_travel(kBusyIndicatorDelay);
  if (travel_) state_.work = travel_stage();
}

void RunController::continue_travel(double seconds) {
  if (!travel_) return;
  if (std::exchange(state_.cancel_work, false)) {
    travel_->last = timeline_.step();
    takes_recorded_step_ = false;
    log_message(state_, ui::LogLevel::warning, "Interrupted at step " + std::to_string(travel_->last) + ".");
  }
  using Clock = std::chrono::steady_clock;
  const auto end = Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
  while (timeline_.step() < travel_->last && Clock::now() < end) timeline_.advance();
  if (timeline_.step() < travel_->last) return;
  travel_.reset();
  arrive();
  if (takes_recorded_step_) microsteps_.record(timeline_.before_step());
}

std::string RunController::travel_stage() const {
  if (!travel_) return {};
  return "Repeating step " + std::to_string(timeline_.step() - travel_->first) + " of " +
         std::to_string(travel_->last - travel_->first) + ", going to step " + std::to_string(travel_->last);
}

void RunController::arrive() {
  ++arrivals_;
  leave_state();
  return_to_stop();
  adopt_materials();
  utilizations_.forget_from(frame().time);
  pace_.restart();
  viewport_.restart_range();
  remember();
}

std::string RunController::moment_text() const {
  const std::string step = "step " + std::to_string(timeline_.step());
  return timeline_.branches().size() > 1 ? step + " of branch " + std::to_string(timeline_.branch()) : step;
}

}  // namespace griffith::app
