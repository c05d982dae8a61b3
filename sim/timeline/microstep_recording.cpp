#include "sim/timeline/microstep_recording.h"

#include <utility>

#include "sim/core/monitor.h"

namespace griffith {

std::int64_t count_microsteps(World before, const std::function<bool()>& cancelled) {
  MicrostepRecording none({.first = std::numeric_limits<std::int64_t>::max()}, 0, cancelled);
  before.step(none.observer());
  return none.microsteps();
}

MicrostepRecording::MicrostepRecording(const MicrostepRange& range, std::size_t memory, std::function<bool()> cancelled)
    : range_(range), memory_(memory), cancelled_(std::move(cancelled)) {}

MicrostepObserver MicrostepRecording::observer() {
  return {[this](std::int64_t microstep) { return wants(microstep); },
          [this](std::int64_t microstep, World moment) { take(microstep, std::move(moment)); },
          [this](std::int64_t microstep) { undo(microstep); }};
}

bool MicrostepRecording::wants(std::int64_t microstep) {
  if (cancelled_ && cancelled_()) throw Cancelled();
  microsteps_ = microstep;
  return microstep >= range_.first && microstep <= range_.last && (microstep - range_.first) % range_.interval == 0;
}

void MicrostepRecording::take(std::int64_t microstep, World moment) {
  moments_.push_back({microstep, std::move(moment)});
  used_ += size_of(moments_.size() - 1);
  while (moments_.size() > 2 && used_ > memory_) remove_every_other();
}

void MicrostepRecording::undo(std::int64_t microstep) {
  microsteps_ = microstep;
  std::erase_if(moments_, [&](const Moment& moment) { return moment.microstep > microstep; });
  count_memory();
}

void MicrostepRecording::remove_every_other() {
  range_.interval *= 2;
  std::erase_if(moments_,
                [&](const Moment& moment) { return (moment.microstep - range_.first) % range_.interval != 0; });
  count_memory();
}

void MicrostepRecording::count_memory() {
  used_ = 0;
  for (std::size_t i = 0; i < moments_.size(); ++i) used_ += size_of(i);
}

/// Returns the size of a moment without the data that it shares with the one before it [bytes].
std::size_t MicrostepRecording::size_of(std::size_t index) const {
  return moments_[index].world.memory(index > 0 ? &moments_[index - 1].world : nullptr);
}

}  // namespace griffith
