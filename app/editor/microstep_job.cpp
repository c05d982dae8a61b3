#include "app/editor/microstep_job.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "sim/core/low_priority.h"
#include "sim/core/number_text.h"

namespace griffith::app {

MicrostepJob::MicrostepJob(NextStep step, const std::optional<MicrostepRange>& range, std::size_t memory)
    : step_(step.world.frame().step + 1),
      result_(std::async(std::launch::async, [this, next = std::move(step), range, memory]() mutable {
        const LowPriority background;
        return record(std::move(next), range, memory);
      })) {}

RecordedStep MicrostepJob::record(NextStep step, std::optional<MicrostepRange> range, std::size_t memory) {
  const auto is_cancelled = [this] {
    ++made_;
    return cancelled_.load();
  };
  expected_ = count_microsteps(step.world, [this] { return cancelled_.load(); });
  if (!range)
    range = MicrostepRange{.interval = std::max<std::int64_t>(1, (expected_ + kMostMoments - 1) / kMostMoments)};
  RecordedStep recorded{step, MicrostepRecording(*range, memory, is_cancelled), {step.world, {}}};
  recorded.made = make_step(std::move(step), recorded.recording.observer());
  return recorded;
}

std::string MicrostepJob::stage() const {
  const std::string stage = "Recording microsteps of step " + std::to_string(step_);
  if (expected_ == 0) return stage;
  return stage + ": " + count_text(std::min(made_.load(), expected_.load())) + " of " + count_text(expected_);
}

bool MicrostepJob::is_ready() const { return result_.wait_for(std::chrono::seconds(0)) == std::future_status::ready; }

}  // namespace griffith::app
