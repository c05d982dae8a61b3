// The part of RunController that shows microsteps.
#include <utility>

#include "app/editor/messages.h"
#include "app/editor/picking.h"
#include "app/editor/run_controller.h"

namespace griffith::app {

void RunController::record_microsteps() {
  state_.running = false;
  if (state_.stop) return microsteps_.record(timeline_.before_step());
  approach(timeline_.branch(), timeline_.step() - 1, true);
}

void RunController::continue_recording() {
  if (!microsteps_.records()) return;
  if (std::exchange(state_.cancel_work, false)) microsteps_.cancel();
  if (!microsteps_.is_ready()) return;
  std::optional<RecordedStep> recorded = microsteps_.take();
  if (std::exchange(takes_recorded_step_, false)) {
    if (!recorded) return approach(timeline_.branch(), timeline_.step() + 1);
    timeline_.take_step(std::move(recorded->made));
    arrive();
  }
  if (!recorded) return;
  if (recorded->recording.moments().empty())
    return log_message(state_, ui::LogLevel::info,
                       "The step has no microsteps: nothing was struck and nothing cracked.", ui::LogSpan::action);
  state_.log_passed = state_.log.size();  // messages about the state between steps
  microsteps_.show(std::move(*recorded));
  follow_shown_world();
}

void RunController::go_to_moment(std::int64_t moment) {
  state_.microsteps->playing = false;
  microsteps_.go_to(moment);
  follow_shown_world();
}

void RunController::close_microsteps() {
  if (!microsteps_.is_open()) return;
  microsteps_.close();
  follow_shown_world();
}

void RunController::follow_shown_world() {
  ++arrivals_;
  forget_contact();
  const Frame now = frame();
  select(state_, now, ui::follow(state_.selection, now));
}

}  // namespace griffith::app
