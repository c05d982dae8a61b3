#pragma once

#include <cstdint>
#include <functional>

namespace griffith {

class World;

/// Callbacks that observe the microsteps of a step. Whatever they take, the step has the same bits.
struct MicrostepObserver {
  /// True if the world after a microstep is to be taken. Called after each of them, numbered from 1 in the order of
  /// computation. Impacts that are followed alone come one after another, so times may go back. May throw Cancelled,
  /// after which the world that makes the step is invalid.
  std::function<bool(std::int64_t microstep)> wants;
  /// Takes the world as it is after a microstep: pieces parted so far are bodies, energies are those before. It is for
  /// frames only and makes no steps.
  std::function<void(std::int64_t microstep, World moment)> take;
  /// Forgets the microsteps after this one: they are undone, and their numbers will be used again.
  std::function<void(std::int64_t microstep)> undo;
};

}  // namespace griffith
