#pragma once

#include <cstdint>
#include <functional>

namespace griffith {

struct WorldState;

/// Callbacks of a step whose microsteps are observed, as MicrostepObserver.
struct MicrostepWatch {
  std::function<bool(std::int64_t microstep)> wants;
  std::function<void(std::int64_t microstep, WorldState&& moment)> take;
  std::function<void(std::int64_t microstep)> undo;
  std::int64_t microsteps = 0;  ///< number of microsteps so far

  /// Counts a microstep. True if the state after it is wanted.
  bool wants_next() { return wants(++microsteps); }
  /// Forgets the microsteps after this one.
  void go_back(std::int64_t microstep) {
    if (microstep < microsteps) undo(microsteps = microstep);
  }
};

}  // namespace griffith
