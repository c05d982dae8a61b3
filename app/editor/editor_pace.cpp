#include <imgui.h>

#include <algorithm>
#include <utility>

#include "app/editor/editor.h"
#include "app/editor/frame_schedule.h"

namespace griffith::app {
namespace {

/// Weight of the newest step in a mean.
constexpr double kNewest = 0.1;

// Intervals at which an idle window redraws the progress of work, arriving pictures and the text cursor [s].
constexpr double kWorkPause = 1.0 / 30, kPicturePause = 0.1, kCursorPause = 0.4;

/// Returns the time of a frame for steps before they continue in the background.
std::chrono::duration<double> time_for_steps(double elapsed) {
  constexpr double kShortest = 0.004, kLongest = 0.04;  // [s]
  return std::chrono::duration<double>(std::clamp(elapsed / 2, kShortest, kLongest));
}

}  // namespace

void Editor::advance(double elapsed) {
  pictures_drawn_.add(elapsed, 1);
  time_made_.add(elapsed, std::exchange(made_since_advance_, 0));  // the steps of the last call count at its end
  if (!state_.running) state_.steps_left = 0;
  if (state_.running) make_due_steps(elapsed);
}

void Editor::reset_pace() {
  pacer_.reset();
  pictures_drawn_.reset();
  time_made_.reset();
  made_since_advance_ = 0;
}

double Editor::seconds_to_next_frame() const {
  if (state_.running || travel_ || export_ || !state_.waiting.empty()) return kDrawAtOnce;
  if (!state_.work.empty()) return kWorkPause;
  if (gallery_ && !gallery_->done()) return kPicturePause;
  return ImGui::GetIO().WantTextInput ? kCursorPause : kDrawNever;
}

void Editor::make_due_steps(double elapsed) {
  using Clock = BackgroundStep::Clock;
  const double time_step = history_.scene().simulation.time_step;
  const auto deadline = Clock::now() + std::chrono::duration_cast<Clock::duration>(time_for_steps(elapsed));
  if (background_.pending() && !end_background_step(Clock::now())) return pacer_.wait(elapsed, state_.speed, time_step);
  const bool counted = state_.steps_left > 0;
  const int steps = counted ? ui::kMaxAskedSteps : pacer_.steps_due(elapsed, state_.speed, time_step, step_seconds_);
  for (int i = 0; i < steps && state_.running && (!counted || i == 0 || Clock::now() < deadline); ++i) {
    if (waits_for_steps_) {
      step();
      continue;
    }
    const bool is_last = i + 1 == steps || Clock::now() + std::chrono::duration<double>(step_seconds_) >= deadline;
    begin_background_step(is_last);
    if (!end_background_step(deadline)) return;
  }
}

void Editor::begin_background_step(bool is_last) {
  if (history_.editing()) follow_materials();  // a slider being dragged acts from step to step
  NextStep next = timeline_.before_step();
  adopt_materials();  // those of the replayed past
  std::optional<StepPicture> picture;
  if (is_last) picture = StepPicture{picture_settings(), display_, range_};
  background_.begin(std::move(next), std::move(picture), step_start());
}

bool Editor::end_background_step(BackgroundStep::Clock::time_point deadline) {
  if (!background_.wait_until(deadline)) return false;
  const bool fits = background_.fits(step_start());
  BackgroundStep::Made made = background_.take();
  if (fits) take_step(std::move(made));
  return true;
}

void Editor::step() {
  if (background_.fits(step_start())) return take_step(background_.take());
  std::optional<World> before;
  timeline_.advance(watches() ? &before : nullptr);
  follow_step(std::move(before), std::nullopt);
}

void Editor::take_step(BackgroundStep::Made made) {
  const std::int64_t step_alone = timeline_.revision() + 1;
  World before = timeline_.take_step(std::move(made.step));
  if (timeline_.revision() != step_alone) made.picture.reset();  // in the past more than the step was done
  follow_step(watches() ? std::optional(std::move(before)) : std::nullopt, std::move(made.picture));
}

void Editor::follow_step(std::optional<World> before, std::optional<StepPicture> picture) {
  if (before && stop_before_step(std::move(*before))) return;
  made_since_advance_ += history_.scene().simulation.time_step;
  if (state_.steps_left > 0 && --state_.steps_left == 0) state_.running = false;
  leave_state();
  adopt_materials();
  remember();
  const Frame frame = world().frame();
  if (!picture || !take_picture(std::move(*picture))) range_.follow(frame, state_.view.quantity);
  const double seconds = frame.report.milliseconds.step / 1000;
  step_seconds_ = step_seconds_ == 0 ? seconds : step_seconds_ + kNewest * (seconds - step_seconds_);
  if (frame.report.non_finite_values > 0) {
    log(ui::LogLevel::error,
        "Step " + std::to_string(frame.step) + ": values not finite or substeps too short; bodies were frozen.");
  }
}

}  // namespace griffith::app
