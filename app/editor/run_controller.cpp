#include "app/editor/run_controller.h"

#include <algorithm>
#include <utility>

#include "app/editor/breakpoints.h"
#include "app/editor/messages.h"
#include "app/editor/picking.h"
#include "app/shared/scene_world.h"
#include "ui/model/units.h"

namespace griffith::app {
namespace {

/// Returns the time of a frame for steps before they continue in the background.
std::chrono::duration<double> time_for_steps(double elapsed) {
  constexpr double kShortest = 0.004, kLongest = 0.04;  // [s]
  return std::chrono::duration<double>(std::clamp(elapsed / 2, kShortest, kLongest));
}

}  // namespace

RunController::RunController(ui::EditorState& state, SceneDocument& document, Viewport& viewport, BuiltWorld built)
    : state_(state), document_(document), viewport_(viewport), timeline_(std::move(built.world)) {
  begin(std::move(built));
}

void RunController::restart(BuiltWorld built) {
  timeline_ = Timeline(std::move(built.world));
  begin(std::move(built));
}

void RunController::begin(BuiltWorld built) {
  built_ = document_.scene();
  built_at_ = built.started;
  warnings_ = std::move(built.warnings);
  ++world_count_;
  travel_.reset();
  microsteps_.close();
  let_go();
  last_stop_.reset();
  state_.comparison.branch.reset();
  utilizations_.clear();
  run_history_.restart(frame());
  pace_ = {};
  leave_state();
  state_.push_mark.reset();
  state_.symbol.reset();
  remember();
  viewport_.begin(std::move(built.display));
  viewport_.update(shown());
}

WorldVersion RunController::version() const {
  return {world_count_, timeline_.revision(), document_.history().revision(), arrivals_};
}

void RunController::remember() {
  const Frame now = frame();
  utilizations_.record(now);
  run_history_.record(timeline_);
  select(state_, now, ui::follow(state_.selection, now));
}

void RunController::leave_state() {
  forget_contact();
  state_.stop.reset();
  state_.log_passed = state_.log.size();
  passes_stop_ = false;
}

void RunController::return_to_stop() {
  const bool is_there = last_stop_ && last_stop_->branch == timeline_.branch() && last_stop_->step == timeline_.step();
  if (!is_there || state_.running || takes_recorded_step_) return;
  timeline_.before_step();  // which applies the inputs of the step, such as a shot
  passes_stop_ = true;
  state_.stop = last_stop_->stop;
  log_message(state_, ui::LogLevel::warning, "Stopped at " + moment_text() + ". " + state_.stop->reason,
              ui::LogSpan::state);
}

void RunController::forget_contact() {
  if (state_.symbol && state_.symbol->kind == ui::SymbolKind::contact) state_.symbol.reset();
}

void RunController::toggle() {
  if (microsteps_.is_open()) return microsteps_.toggle();
  state_.running = !state_.running;
  state_.steps_left = 0;
  pace_.restart();
}

void RunController::make_steps(std::int64_t count) {
  close_microsteps();
  state_.running = count > 0;
  state_.steps_left = count;
  pace_.restart();
}

void RunController::step_once() {
  if (microsteps_.is_open()) return go_to_moment(state_.microsteps->moment() + 1);
  state_.running = false;
  step();
}

void RunController::advance(double elapsed) {
  pace_.add_picture(elapsed);
  if (microsteps_.play(elapsed)) follow_shown_world();
  if (!state_.running) state_.steps_left = 0;
  if (state_.running) make_due_steps(elapsed);
}

void RunController::make_due_steps(double elapsed) {
  using Clock = BackgroundStep::Clock;
  const double time_step = document_.scene().simulation.time_step;
  const auto deadline = Clock::now() + std::chrono::duration_cast<Clock::duration>(time_for_steps(elapsed));
  if (background_.pending() && !end_background_step(Clock::now()))
    return pace_.pacer().wait(elapsed, state_.speed, time_step);
  const bool counted = state_.steps_left > 0;
  const int steps =
      counted ? ui::kMaxAskedSteps : pace_.pacer().steps_due(elapsed, state_.speed, time_step, pace_.step_seconds());
  for (int i = 0; i < steps && state_.running && (!counted || i == 0 || Clock::now() < deadline); ++i) {
    if (waits_for_steps_) {
      step();
      continue;
    }
    const auto step_end = Clock::now() + std::chrono::duration<double>(pace_.step_seconds());
    begin_background_step(i + 1 == steps || step_end >= deadline);
    if (!end_background_step(deadline)) return;
  }
}

void RunController::begin_background_step(bool is_last) {
  if (document_.history().editing()) follow_materials();  // a slider being dragged acts from step to step
  follow_grab();
  NextStep next = timeline_.before_step();
  adopt_materials();  // those of the replayed past
  std::optional<StepPicture> picture;
  if (is_last) picture = viewport_.next_picture(built_);
  background_.begin(std::move(next), std::move(picture), step_start());
}

bool RunController::end_background_step(BackgroundStep::Clock::time_point deadline) {
  if (!background_.wait_until(deadline)) return false;
  const bool fits = background_.fits(step_start());
  BackgroundStep::Made made = background_.take();
  if (fits) take_step(std::move(made));
  return true;
}

void RunController::step() {
  close_microsteps();
  if (background_.fits(step_start())) return take_step(background_.take());
  follow_grab();
  std::optional<World> before;
  timeline_.advance(watches() ? &before : nullptr);
  follow_step(std::move(before), std::nullopt);
}

void RunController::take_step(BackgroundStep::Made made) {
  const std::int64_t step_alone = timeline_.revision() + 1;
  World before = timeline_.take_step(std::move(made.step));
  if (timeline_.revision() != step_alone) made.picture.reset();  // in the past more than the step was done
  follow_step(watches() ? std::optional(std::move(before)) : std::nullopt, std::move(made.picture));
}

void RunController::follow_step(std::optional<World> before, std::optional<StepPicture> picture) {
  if (before && stop_before_step(std::move(*before))) return;
  if (state_.steps_left > 0 && --state_.steps_left == 0) state_.running = false;
  leave_state();
  return_to_stop();
  adopt_materials();
  remember();
  viewport_.follow_step(shown(), std::move(picture));
  explain_first_crack();
  const StepReport& report = frame().report;
  pace_.add_step(document_.scene().simulation.time_step, report.milliseconds.step / 1000);
  if (report.non_finite_values > 0)
    log_message(
        state_, ui::LogLevel::error,
        "Step " + std::to_string(frame().step) + ": values not finite or substeps too short; bodies were frozen.");
}

void RunController::explain_first_crack() {
  const Frame now = frame();
  if (!state_.explain_first_crack || now.report.cracks == 0) return;
  state_.explain_first_crack = false;
  const std::size_t first = now.crack_events.size() - static_cast<std::size_t>(now.report.cracks);
  if (!state_.selection.valid()) select_node(state_, now, now.crack_events[first].node);
}

bool RunController::stop_before_step(World before) {
  std::optional<ui::Stop> stop =
      met_breakpoint(state_.breakpoints, before.frame(), frame(), state_.selected_body, state_.selection);
  if (!stop) return false;
  timeline_.take_back(std::move(before));
  state_.running = false;
  last_stop_ = StopPlace{timeline_.branch(), timeline_.step(), *stop};
  arrive();
  if (stop->node.valid()) select_node(state_, frame(), stop->node);
  return true;
}

void RunController::fire(ProjectileBurst shot) {
  close_microsteps();
  timeline_.fire(shot);
  leave_state();
  shot.start = frame().time;
  state_.last_shot = shot;
  if (!state_.running)
    log_message(state_, ui::LogLevel::info, "Fired. Press Space to run the simulation.", ui::LogSpan::action);
}

void RunController::grab(const Grab& grab) {
  close_microsteps();
  timeline_.grab(grab);
  leave_state();
  dragged_to_.reset();
  state_.holds_piece = true;
}

void RunController::drag(const Vec3& target) { dragged_to_ = target; }

void RunController::release() {
  if (frame().grab) timeline_.release();
  leave_state();
  let_go();
}

void RunController::push(const Push& push) {
  close_microsteps();
  const Frame pushed = frame();
  const TetId tet(push.tet);
  const std::array<NodeId, 4>& corners = pushed.elements.tets[tet];
  Vec3 point = (1 - push.weights.sum()) * pushed.nodes.positions[corners[0]];
  for (int i = 0; i < 3; ++i) point += push.weights[i] * pushed.nodes.positions[corners[i + 1]];
  const int body = pushed.bodies[pushed.elements.bodies[tet]].scene_body;
  timeline_.push(push);
  leave_state();
  state_.push_mark = ui::PushMark{timeline_.step(), point, push.impulse};
  log_message(state_, ui::LogLevel::info,
              "Pushed " + built_.bodies[static_cast<std::size_t>(body)].name + " with " +
                  ui::format_quantity(push.impulse.norm(), "N·s") +
                  (state_.running ? "." : ". Press Space to run the simulation."),
              ui::LogSpan::action);
}

void RunController::let_go() {
  dragged_to_.reset();
  state_.holds_piece = false;
}

void RunController::follow_grab() {
  if (!frame().grab) return let_go();
  if (dragged_to_) timeline_.move_grab(*std::exchange(dragged_to_, std::nullopt));
  if (!state_.holds_piece && timeline_.step() == timeline_.last_step()) timeline_.release();
}

void RunController::follow_materials() {
  const std::vector<BodyDescription>& bodies = document_.scene().bodies;
  const Frame now = frame();
  if (!std::ranges::equal(bodies, built_.bodies, {}, &BodyDescription::name, &BodyDescription::name) ||
      now.materials.size() != bodies.size())
    return;  // they come with the world being built
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (now.materials[i] != bodies[i].material && !follow_material(static_cast<int>(i))) return;
    built_.bodies[i].material = bodies[i].material;
  }
}

bool RunController::follow_material(int scene_body) {
  close_microsteps();
  try {
    timeline_.set_material(scene_body, document_.scene().bodies[scene_body].material);
    document_.history().set_later_edits(false);
    viewport_.restart_range();
    leave_state();
    return true;
  } catch (const InputError& error) {
    show_error(state_, in_file(document_.path(), error));
    const std::span<const Material> in_force = frame().materials;
    const bool found = document_.history().go_to(
        [&](const Scene& scene) { return std::ranges::equal(scene.bodies, in_force, {}, &BodyDescription::material); });
    if (!found) document_.history().undo();  // some bodies accepted the material before one refused it
    return false;
  }
}

/// True if the branch ends with materials that are neither in force nor in the saved scene.
bool RunController::has_later_edits() const {
  if (timeline_.step() == timeline_.last_step()) return false;
  const std::span<const Material> in_force = frame().materials;
  const std::vector<BodyDescription>& saved = document_.history().saved().bodies;
  if (in_force.size() != saved.size()) return false;
  std::vector<Material> last(in_force.begin(), in_force.end());
  for (const WorldInput& input : timeline_.inputs())
    if (const auto* change = std::get_if<MaterialChange>(&input.action); change && input.step > timeline_.step())
      last[static_cast<std::size_t>(change->scene_body)] = change->material;
  for (std::size_t i = 0; i < last.size(); ++i)
    if (last[i] != in_force[i] && last[i] != saved[i].material) return true;
  return false;
}

void RunController::adopt_materials() {
  document_.history().set_later_edits(has_later_edits());
  const std::span<const Material> in_force = frame().materials;
  const std::vector<BodyDescription>& bodies = document_.scene().bodies;
  if (document_.history().editing() || in_force.size() != bodies.size() ||
      std::ranges::equal(bodies, in_force, {}, &BodyDescription::material))
    return;
  document_.history().adopt([&](Scene& scene) {
    for (std::size_t i = 0; i < in_force.size(); ++i) scene.bodies[i].material = in_force[i];
  });
  for (std::size_t i = 0; i < in_force.size(); ++i) built_.bodies[i].material = in_force[i];
}

std::vector<ui::UtilizationSample> RunController::utilizations() const {
  if (!state_.selection.valid()) return {};
  return utilizations_.samples(frame(), state_.selection.node);
}

void RunController::describe(ui::EditorInput& input) const {
  input.time = time_view();
  if (dragged_to_ && input.frame.grab) input.frame.grab->target = *dragged_to_;
  input.microsteps = microsteps_.view();
  input.series = run_history_.series();
  input.time_step = document_.scene().simulation.time_step;
  input.step_milliseconds = 1000 * pace_.step_seconds();
  input.step_in_progress = background_.age();
  input.frames_per_second = pace_.pictures_per_second();
  input.reached_speed = pace_.reached_speed();
  input.falling_behind = pace_.falling_behind();
}

ui::TimeView RunController::time_view() const {
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
