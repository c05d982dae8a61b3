#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "app/output/outcome.h"
#include "sim/world/output/frame.h"

namespace griffith::app {

/// Statistics of a run: totals of counters and times of all steps.
class RunStatistics {
 public:
  /// `start`: the frame before the first step. `time_step` [s].
  RunStatistics(const Frame& start, double time_step, int threads);

  /// Adds the step that led to `frame`.
  void add(const Frame& frame);

  /// Returns a JSON object in SI units: outcome_kinds() by their keys, whose dots separate nested members, null if
  /// infinite. `ms` has the times in milliseconds of steps, of their phases, and `processor`, the time of all threads
  /// between the ends of two steps. `scaled_impacts` lists the slowest scaled impact (ScaledImpact) of each scene body,
  /// with the effective material and the reason. `broke_scaled` lists fracture under scaling (ScaledBreak) by scene
  /// body: existing pieces, cracks, the smallest factor, the effective material and the reason. `element_choices` lists
  /// the elements of bodies whose scene leaves the choice, and the reason. `frame`: the last one.
  std::string json(const Frame& frame, std::uint64_t state_hash) const;

  /// Returns the input of outcomes_of() for the steps so far.
  const RunTally& tally() const { return tally_; }

  /// Returns a summary of a few lines for people.
  std::string summary(const Frame& frame, std::uint64_t state_hash) const;

 private:
  double time_step_;
  int threads_;
  RunTally tally_;
  struct ScaledBody {
    std::int64_t step = 0;  ///< step of the slowest
    int impacts = 0;        ///< steps in which the body or a piece of it was scaled
    ScaledImpact slowest;
  };
  std::map<int, ScaledBody> scaled_;  ///< by scene body
  double processor_;                  ///< processor time at the end of the last step [ms]
  std::array<std::vector<double>, 7>
      milliseconds_;  ///< times of the step, its phases, and processor time of all threads
};

}  // namespace griffith::app
