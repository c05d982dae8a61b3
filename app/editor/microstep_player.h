#pragma once

#include <memory>
#include <optional>
#include <string>

#include "app/editor/microstep_job.h"
#include "ui/model/editor_state.h"

namespace griffith::app {

/// Records microsteps of a step and plays them in slow motion.
class MicrostepPlayer {
 public:
  explicit MicrostepPlayer(ui::EditorState& state) : state_(state) {}

  /// Begins to record the microsteps of a step.
  void record(NextStep step);
  /// True while it records.
  bool records() const { return job_ != nullptr; }
  /// Describes the progress of the recording; empty if there is none.
  std::string stage() const { return job_ ? job_->stage() : std::string(); }
  /// Ends the recording early.
  void cancel() { job_->cancel(); }
  /// True once the recording has ended.
  bool is_ready() const { return job_ && job_->is_ready(); }
  /// Returns the recorded step; empty if the recording was cancelled.
  std::optional<RecordedStep> take();

  /// Shows the microsteps of a recorded step, which has some.
  void show(RecordedStep recorded);
  /// Ends playback.
  void close();
  /// True while recorded microsteps are shown.
  bool is_open() const { return recorded_.has_value(); }
  /// Returns the shown world; null if none is.
  const World* world() const;
  /// Describes the recording, while it is shown.
  const std::optional<ui::MicrostepView>& view() const { return view_; }

  /// Shows a recorded moment, or the nearest one.
  void go_to(std::int64_t moment);
  void toggle();
  /// Plays on by `elapsed` [s] of real time. True if another moment is shown.
  bool play(double elapsed);
  /// Records again around the shown moment, at an eighth of the interval.
  void record_finer();
  /// Records all microsteps of the step again.
  void record_whole() { record(recorded_->before); }

 private:
  std::size_t memory() const;
  void begin(NextStep step, const std::optional<MicrostepRange>& range);
  int last() const { return static_cast<int>(view_->moments.size()) - 1; }

  ui::EditorState& state_;
  std::unique_ptr<MicrostepJob> job_;
  std::int64_t sought_ = 0;  ///< microstep that is shown first when it is recorded
  std::optional<RecordedStep> recorded_;
  std::optional<ui::MicrostepView> view_;
};

}  // namespace griffith::app
