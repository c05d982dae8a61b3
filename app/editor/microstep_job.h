#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <future>
#include <optional>
#include <string>

#include "sim/timeline/microstep_recording.h"
#include "sim/timeline/timeline.h"

namespace griffith::app {

/// Step whose microsteps are recorded.
struct RecordedStep {
  NextStep before;  ///< from which other microsteps of it can be recorded
  MicrostepRecording recording;
  MadeStep made;
};

/// Records the microsteps of a step on a thread of its own. The destructor cancels it.
class MicrostepJob {
 public:
  /// `range`: microsteps to record; empty: all, at an interval that makes at most kMostMoments. `memory`: as for
  /// MicrostepRecording [bytes].
  MicrostepJob(NextStep step, const std::optional<MicrostepRange>& range, std::size_t memory);
  ~MicrostepJob() { cancel(); }

  void cancel() { cancelled_ = true; }
  /// Describes the progress: "Recording microsteps of step 32: 1,200 of 5,876".
  std::string stage() const;
  /// True once the step is recorded or the work has ended early.
  bool is_ready() const;
  /// Waits for the recorded step. Throws Cancelled if it was cancelled.
  RecordedStep take() { return result_.get(); }

  /// Number of moments that one recording has at most, for some ten seconds of fluent playback.
  static constexpr std::int64_t kMostMoments = 240;

 private:
  RecordedStep record(NextStep step, std::optional<MicrostepRange> range, std::size_t memory);

  std::int64_t step_;
  std::atomic<bool> cancelled_ = false;
  std::atomic<std::int64_t> made_ = 0, expected_ = 0;  ///< microsteps
  std::future<RecordedStep> result_;                   ///< ends before the data of its thread
};

}  // namespace griffith::app
