#pragma once

namespace griffith {

/// What a substep cost beyond looking at each of its elements, in microseconds of a usual core. It is counted, not
/// timed: a step does the same on every machine and whatever else runs there.
struct Work {
  double solves = 0, contacts = 0, cracks = 0;

  /// What a step may cost.
  static constexpr double kPerStep = 11'000;
  static constexpr double kPerBody = 10, kPerTet = 0.75;
  static constexpr double kPerTetAndIteration = 0.013;
  static constexpr double kPerContact = 4, kPerTouchedPoint = 7, kPerRelaxation = 0.11;
  static constexpr double kPerCrack = 60, kPerRebuiltTet = 1.5;
};

}  // namespace griffith
