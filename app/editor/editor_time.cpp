#include <algorithm>
#include <chrono>
#include <utility>

#include "app/editor/breakpoints.h"
#include "app/editor/editor.h"
#include "app/editor/holding_report.h"

namespace griffith::app {
using ui::CommandId;

void Editor::carry_out_in_time(const ui::Command& command) {
  follow_edits();  // the last edits belong to the time that is left
  if (command.id == CommandId::explain_holding) return explain_holding();
  state_.running = false;
  switch (command.id) {
    case CommandId::step_back:
      return go_to(timeline_.branch(), timeline_.step() - 1);
    case CommandId::go_to_start:
      return go_to(timeline_.branch(), timeline_.first_step());
    case CommandId::go_to_end:
      return go_to(timeline_.branch(), timeline_.last_step());
    case CommandId::go_to_branch:
      return go_to_recorded(command.branch, command.step);
    default:
      return go_to_recorded(timeline_.branch(), command.step);
  }
}

void Editor::go_to_recorded(int branch, std::int64_t step) {
  const std::span<const Branch> branches = timeline_.branches();
  const auto refuse = [](const std::string& what, const std::string& range) {
    throw InputError(what, "was not recorded", "there is " + range);
  };
  const auto numbers = [](std::int64_t first, std::int64_t last) {
    return std::to_string(first) + " to " + std::to_string(last);
  };
  if (branch < 0 || branch >= static_cast<int>(branches.size()))
    refuse("branch " + std::to_string(branch), "branch " + numbers(0, static_cast<std::int64_t>(branches.size()) - 1));
  const std::int64_t last = branches[branch].last_step;
  if (step < timeline_.first_step() || step > last)
    refuse("step " + std::to_string(step) + " of branch " + std::to_string(branch),
           "step " + numbers(timeline_.first_step(), last));
  go_to(branch, step);
}

void Editor::go_to(int branch, std::int64_t step) {
  history_.finish();
  if (branch != timeline_.branch()) {
    history_of_utilizations_.clear();
    if (state_.comparison.branch == branch) state_.comparison.branch = timeline_.branch();  // the two branches swap
  }
  const std::int64_t destination = timeline_.approach(branch, step);
  travel_ = {timeline_.step(), destination};
  continue_travel(kBusyIndicatorDelay);
  if (travel_) state_.work = travel_stage();
}

void Editor::continue_travel(double seconds) {
  if (!travel_) return;
  if (std::exchange(state_.cancel_work, false)) {
    travel_->last = timeline_.step();
    log(ui::LogLevel::warning, "Interrupted at step " + std::to_string(travel_->last) + ".");
  }
  using Clock = std::chrono::steady_clock;
  const auto end = Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
  while (timeline_.step() < travel_->last && Clock::now() < end) timeline_.advance();
  if (timeline_.step() < travel_->last) return;
  travel_.reset();
  arrive();
}

std::string Editor::travel_stage() const {
  return "Repeating step " + std::to_string(timeline_.step() - travel_->first) + " of " +
         std::to_string(travel_->last - travel_->first) + ", going to step " + std::to_string(travel_->last);
}

/// Updates the editor after a jump in time.
void Editor::arrive() {
  ++arrivals_;
  leave_state();
  adopt_materials();
  history_of_utilizations_.forget_from(frame().time);
  reset_pace();
  range_.restart();
  remember();
}

void Editor::adopt_materials() {
  const std::span<const Material> in_force = frame().materials;
  const std::vector<BodyDescription>& bodies = history_.scene().bodies;
  if (history_.editing() || in_force.size() != bodies.size() ||
      std::ranges::equal(bodies, in_force, {}, &BodyDescription::material))
    return;
  history_.adopt([&](Scene& scene) {
    for (std::size_t i = 0; i < in_force.size(); ++i) scene.bodies[i].material = in_force[i];
  });
  for (std::size_t i = 0; i < in_force.size(); ++i) built_.bodies[i].material = in_force[i];
}

bool Editor::stop_before_step(World before) {
  std::optional<ui::Stop> stop =
      met_breakpoint(state_.breakpoints, before.frame(), frame(), state_.selected_body, state_.selection);
  if (!stop) return false;
  timeline_.take_back(std::move(before));
  arrive();
  state_.running = false;
  passes_stop_ = true;
  if (stop->node.valid()) select_node(stop->node);
  log(ui::LogLevel::warning, "Stopped at " + moment_text() + ". " + stop->reason, ui::LogSpan::state);
  state_.stop = std::move(stop);
  return true;
}

std::string Editor::moment_text() const {
  const std::string step = "step " + std::to_string(timeline_.step());
  return timeline_.branches().size() > 1 ? step + " of branch " + std::to_string(timeline_.branch()) : step;
}

void Editor::leave_state() {
  state_.stop.reset();
  state_.log_passed = state_.log.size();
  passes_stop_ = false;
}

void Editor::explain_holding() {
  if (!state_.stop || !state_.stop->node.valid()) return;
  state_.running = false;
  holding_ = std::make_unique<HoldingSearch>(timeline_, state_.stop->node);
  state_.work = holding_->stage();
}

void Editor::go_on_with_holding() {
  if (!holding_) return;
  if (std::exchange(state_.cancel_work, false)) holding_->cancel();
  const std::optional<HoldingAnswer> answer = holding_->take();
  if (!answer) return;
  state_.report = holding_report(*answer, holding_->run());
  holding_.reset();
}

ui::TimeView Editor::time_view() const {
  ui::TimeView view;
  view.first_step = timeline_.first_step();
  view.last_step = timeline_.last_step();
  view.time_step = built_.simulation.time_step;
  view.branch = timeline_.branch();
  for (const Branch& branch : timeline_.branches())
    view.branches.push_back({branch.parent, branch.first_step, branch.last_step});
  for (const StepMark& mark : timeline_.marks())
    view.ticks.push_back({mark.step, mark.cracks, mark.impacts, mark.alarm});
  return view;
}

}  // namespace griffith::app
