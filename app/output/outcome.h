#pragma once

#include <functional>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "sim/world/output/frame.h"

namespace griffith::app {

/// Value of a time that never came.
inline constexpr double kNever = std::numeric_limits<double>::infinity();

/// Accumulated values of all steps before the last frame of a run.
struct RunTally {
  /// `start`: the frame before the first step.
  explicit RunTally(const Frame& start);

  double initial_mass = 0;        ///< mass of the bodies [kg]
  double breaking_time = kNever;  ///< end of the first step with a fragment [s]
  double peak_utilization = 0;
  double least_scaling = 1;  ///< smallest factor of any scaled impact
  int trouble = 0;           ///< sum of all counters that warn (step_counters.h)
  StepReport total;          ///< totals of all steps, by add_step()

  /// Adds the step that led to `frame`.
  void add(const Frame& frame);
};

/// A finished run.
struct EndOfRun {
  const Frame& frame;  ///< last frame
  const RunTally& tally;
  std::vector<double> masses;  ///< masses of the pieces, ascending [kg]
};

/// Places where an outcome is listed; statistics, expressions and records contain all.
enum class OutcomeListing {
  main,       ///< tables of pages and all other lists
  more,       ///< CSV files and the plots of pages
  other_name  ///< none: another outcome has the same value
};

/// A number that summarizes a run; the same whenever the run is repeated.
struct OutcomeKind {
  std::string key;      ///< in files and expressions: "largest_piece", "energy.contacts"
  std::string unit;     ///< "kg"; "-" for a ratio, "" for a count
  std::string meaning;  ///< a phrase
  OutcomeListing listing = OutcomeListing::main;
  std::function<double(const EndOfRun& run)> value;
};

/// Returns all outcomes in the order of tables. A new one is an entry of the table in outcome.cpp, a counter
/// (sim/world/output/step_counters.cpp) or an entry of the energy account.
std::span<const OutcomeKind> outcome_kinds();

/// Returns the index of an outcome by its key. Throws InputError, which names `where` and the most similar key.
std::size_t outcome_index(std::string_view key, const std::string& where);

/// Values of outcome_kinds(), in their order.
using Outcomes = std::vector<double>;

/// Returns the outcomes of a run that ends with `frame`.
Outcomes outcomes_of(const Frame& frame, const RunTally& tally);

}  // namespace griffith::app
