#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/editor/background_step.h"
#include "app/editor/microstep_player.h"
#include "app/editor/run_history.h"
#include "app/editor/run_pace.h"
#include "app/editor/scene_document.h"
#include "app/editor/utilization_history.h"
#include "app/editor/viewport.h"
#include "app/editor/world_loader.h"
#include "sim/timeline/timeline.h"

namespace griffith::app {

/// The world with its past: makes steps at the requested pace, stops them at breakpoints, goes to recorded ones.
/// Materials of the edited scene act at once; those in force at another time become the scene's.
class RunController {
 public:
  /// `built`: world of the document's scene.
  RunController(ui::EditorState& state, SceneDocument& document, Viewport& viewport, BuiltWorld built);
  /// Replaces the world by another of the document's scene.
  void restart(BuiltWorld built);

  const Timeline& timeline() const { return timeline_; }
  /// Returns the shown world: that of the timeline, or one between its microsteps.
  const World& world() const { return microsteps_.is_open() ? *microsteps_.world() : timeline_.world(); }
  Frame frame() const { return world().frame(); }
  /// Returns the scene from which the world was built, with its current materials.
  const Scene& built() const { return built_; }
  /// Returns the time before any file of that scene was read.
  std::filesystem::file_time_type built_at() const { return built_at_; }
  /// Returns the warnings of that scene.
  const std::vector<InputError>& warnings() const { return warnings_; }
  ShownWorld shown() const { return {frame(), built_, version()}; }

  /// Runs or pauses, or plays the shown microsteps or pauses them.
  void toggle();
  /// Runs until that many steps are made.
  void make_steps(std::int64_t count);
  /// Pauses and makes one step, or goes to the next of the shown microsteps.
  void step_once();
  /// Makes one time step.
  void step();
  /// Makes the time steps that are due after `elapsed` [s] of real time, if the simulation runs.
  void advance(double elapsed);
  /// Lets advance() finish slow steps in the background while the window draws. This affects which steps are shown, but
  /// no step itself. `done`: called on their thread at the end of each.
  void step_in_background(std::function<void()> done = {}) {
    waits_for_steps_ = false;
    background_.call_when_done(std::move(done));
  }
  /// True if a step is in progress in the background, or finished there and not taken.
  bool steps_in_background() const { return background_.pending(); }
  /// True if the run waits for a step in the background: until it ends, there is no other picture.
  bool waits_for_step() const { return state_.running && background_.in_progress(); }
  void fire(ProjectileBurst shot);
  /// Pulls a piece by a spring until release().
  void grab(const Grab& grab);
  /// Moves the target of the grab before the next step [m].
  void drag(const Vec3& target);
  void release();
  /// Pushes a piece in the next step.
  void push(const Push& push);
  /// Returns the target of the grab, which must exist [m].
  Vec3 target() const { return dragged_to_ ? *dragged_to_ : frame().grab->target; }
  /// Describes the shown step: "step 31", with its branch if there are several.
  std::string moment_text() const;
  /// Applies the scene's materials. A material that the world does not accept is undone, with an error.
  void follow_materials();

  /// Pauses and goes to a recorded step. Throws InputError if there is none. A long way is continued by
  /// continue_travel().
  void go_to(int branch, std::int64_t step);
  /// The same on the shown branch, to the nearest recorded step.
  void go_to_nearest(std::int64_t step);
  /// Recomputes past steps toward the requested one, for at most that many seconds.
  void continue_travel(double seconds);
  /// Describes the way that is left; empty if there is none.
  std::string travel_stage() const;
  /// Records the microsteps of the last step, or of the next one if the run has stopped before it, and shows them.
  void record_microsteps();
  /// Shows them once they are recorded. Call it in every drawn frame.
  void continue_recording();
  /// Describes the progress of the recording; empty if there is none.
  std::string recording_stage() const { return microsteps_.stage(); }
  /// Goes to a moment of the shown microsteps, or the nearest one.
  void go_to_moment(std::int64_t moment);
  void record_finer_microsteps() { microsteps_.record_finer(); }
  void record_whole_step() { microsteps_.record_whole(); }
  /// Returns from microsteps to the state at the end of the step, or to where the run stopped before it.
  void close_microsteps();
  /// True if the simulation runs slower than requested.
  bool lags() const { return state_.running && pace_.falling_behind(); }
  /// Sets the approximate limit for copies of the world [bytes].
  void limit_memory(std::size_t memory) { timeline_.limit_memory(memory); }

  /// Returns the recorded values of all steps.
  const RunHistory& history() const { return run_history_; }
  /// Returns the past of the selected node.
  std::vector<ui::UtilizationSample> utilizations() const;
  /// Adds the past and the measured speeds to the input of the panels.
  void describe(ui::EditorInput& input) const;
  ui::TimeView time_view() const;

 private:
  /// A stop of this run and its place. Other inputs there begin another branch, so it stays valid.
  struct StopPlace {
    int branch = 0;
    std::int64_t step = 0;
    ui::Stop stop;
  };

  void begin(BuiltWorld built);
  WorldVersion version() const;
  void remember();
  /// Clears the stop and the messages of the shown state.
  void leave_state();
  /// Shows the last stop if the run stands there, or stands there again.
  void return_to_stop();
  /// Clears a picked contact, which is one of the shown state.
  void forget_contact();
  /// True if the world accepted the material; else the edit is undone.
  bool follow_material(int scene_body);
  /// Makes the materials in force those of the scene, without an entry in its history.
  void adopt_materials();
  bool has_later_edits() const;

  void make_due_steps(double elapsed);
  /// `is_last`: last step before the next picture, which is made with it.
  void begin_background_step(bool is_last);
  /// Waits for the background step. True if it is finished by then. It is discarded if the world has changed meanwhile.
  bool end_background_step(BackgroundStep::Clock::time_point deadline);
  /// Forgets the grab without an input.
  void let_go();
  /// Moves the grab before a step to its target, or ends one of the repeated past that nobody holds any more.
  void follow_grab();
  /// Returns the starting point of a background step.
  BackgroundStep::Start step_start() const { return {world_count_, timeline_.revision()}; }
  void take_step(BackgroundStep::Made made);
  /// Handles a finished step. `before`: the world before it, if breakpoints are set. `picture`: of the world, if any.
  void follow_step(std::optional<World> before, std::optional<StepPicture> picture);
  bool watches() const { return state_.breakpoints.any() && !passes_stop_; }
  /// Selects the node of the first crack if that was requested and nothing else is selected.
  void explain_first_crack();
  /// True if a breakpoint lies in the step just made from `before`; the step is then undone.
  bool stop_before_step(World before);

  /// `records`: the microsteps of the step after the destination are to be recorded.
  void approach(int branch, std::int64_t step, bool records = false);
  /// Lets picture and selection follow a change of world().
  void follow_shown_world();
  /// Updates everything after a jump in time.
  void arrive();

  ui::EditorState& state_;
  SceneDocument& document_;
  Viewport& viewport_;
  Timeline timeline_;
  Scene built_;
  std::filesystem::file_time_type built_at_;
  std::vector<InputError> warnings_;
  std::int64_t world_count_ = 0;        ///< number of worlds shown so far
  std::int64_t arrivals_ = 0;           ///< number of jumps to another time
  std::optional<Vec3> dragged_to_;      ///< target of the grab from the next step on [m]
  std::optional<ui::StepSpan> travel_;  ///< past steps being recomputed, from the first to the last
  RunHistory run_history_;
  UtilizationHistory utilizations_;
  RunPace pace_;
  BackgroundStep background_;
  MicrostepPlayer microsteps_{state_};
  bool takes_recorded_step_ = false;  ///< the step after the way's end is recorded, then taken
  bool waits_for_steps_ = true;
  std::optional<StopPlace> last_stop_;
  bool passes_stop_ = false;  ///< makes the next step despite its breakpoint
};

}  // namespace griffith::app
