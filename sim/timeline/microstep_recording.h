#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <vector>

#include "sim/world/world.h"

namespace griffith {

/// Microsteps of a step: the first, every `interval`-th after it, up to the last.
struct MicrostepRange {
  std::int64_t first = 1, last = std::numeric_limits<std::int64_t>::max(), interval = 1;
};

/// Returns the number of microsteps of the step that follows. `cancelled`: as for MicrostepRecording.
std::int64_t count_microsteps(World before, const std::function<bool()>& cancelled = {});

/// Worlds between the microsteps of a step, at equal intervals of microsteps. The interval doubles when the memory
/// limit is reached.
class MicrostepRecording {
 public:
  struct Moment {
    std::int64_t microstep = 0;  ///< number in the step, from 1
    World world;                 ///< for frames only
  };

  /// `range`: microsteps to record. `memory`: approximate limit of all moments, but two are always kept [bytes].
  /// `cancelled`: asked after each microstep; true ends the step with the exception Cancelled. May be empty.
  MicrostepRecording(const MicrostepRange& range, std::size_t memory, std::function<bool()> cancelled = {});

  /// Returns the observer that records a step, for World::step() or make_step(). This must stay at its place meanwhile.
  MicrostepObserver observer();

  /// Moments in the order of computation, by ascending number of the microstep.
  std::span<const Moment> moments() const { return moments_; }
  /// Number of microsteps of the step so far.
  std::int64_t microsteps() const { return microsteps_; }
  /// Number of microsteps from one moment to the next.
  std::int64_t interval() const { return range_.interval; }
  /// Approximate size of all moments [bytes]. Data that neighbors share count once.
  std::size_t memory_used() const { return used_; }

 private:
  bool wants(std::int64_t microstep);
  void take(std::int64_t microstep, World moment);
  void undo(std::int64_t microstep);
  std::size_t size_of(std::size_t index) const;
  void remove_every_other();
  void count_memory();

  MicrostepRange range_;
  std::size_t memory_, used_ = 0;
  std::function<bool()> cancelled_;
  std::vector<Moment> moments_;
  std::int64_t microsteps_ = 0;
};

}  // namespace griffith
