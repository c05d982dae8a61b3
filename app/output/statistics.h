#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "app/output/outcome.h"
#include "sim/world/frame.h"

namespace griffith::app {

/// What happened over a run: counters over all steps, the times of each.
class RunStatistics {
 public:
  /// `start`: the frame before the first step. `time_step` [s].
  RunStatistics(const Frame& start, double time_step, int threads);

  /// Takes in the step that led to `frame`.
  void add(const Frame& frame);

  /// One JSON object in SI units: outcome_kinds() by their keys, whose dots lead into objects and lists, null where
  /// infinite. `ms` has the times in milliseconds of steps, of their phases, and `processor` time of all threads from
  /// the end of one step to that of the next. `frame`: the last one.
  /// `scaled_impacts` lists for each scene body whose impacts were scaled (ScaledImpact) the slowest, with the
  /// effective material and the reason. `broke_scaled` lists by scene body what broke so (ScaledBreak): pieces that
  /// there are of it, cracks, the smallest factor, the effective material and the reason.
  std::string json(const Frame& frame, std::uint64_t state_hash) const;

  /// What outcomes_of() needs of the steps so far.
  const RunTally& tally() const { return tally_; }

  /// Says it for a person, in a few lines.
  std::string summary(const Frame& frame, std::uint64_t state_hash) const;

 private:
  double time_step_;
  int threads_;
  RunTally tally_;
  struct ScaledBody {
    std::int64_t step = 0;  ///< of the slowest
    int impacts = 0;        ///< steps in which it or a piece of it was scaled
    ScaledImpact slowest;
  };
  std::map<int, ScaledBody> scaled_;                 ///< by scene body
  double processor_;                                 ///< time of all threads when the last step ended [ms]
  std::array<std::vector<double>, 7> milliseconds_;  ///< of the step, its phases, and processor time of all threads
};

}  // namespace griffith::app
