#pragma once

namespace griffith {

/// What a substep cost beyond looking at each of its elements, in microseconds of a usual core. It is counted, not
/// timed: a step does the same on every machine and whatever else runs there.
struct Work {
  double solves = 0, contacts = 0, cracks = 0;
  /// What the faces that cracked will cost in the next substep, when they touch.
  double fresh_contacts = 0;

  double sum() const { return solves + contacts + cracks; }

  /// What a step may cost.
  static constexpr double kPerStep = 10'000;
  static constexpr double kPerBody = 10, kPerTet = 0.75;
  static constexpr double kPerTetAndIteration = 0.013;
  static constexpr double kPerContact = 4, kPerTouchedPoint = 3, kPerRelaxation = 0.2;
  static constexpr double kPerCrack = 60, kPerRebuiltTet = 1.5, kPerFreshCrack = 150;
};

}  // namespace griffith
