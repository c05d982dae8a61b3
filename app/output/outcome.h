#pragma once

#include <functional>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "sim/world/frame.h"

namespace griffith::app {

/// What a time is that never came.
inline constexpr double kNever = std::numeric_limits<double>::infinity();

/// What outcomes need of the steps that lie behind the last frame of a run.
struct RunTally {
  /// `start`: the frame before the first step.
  explicit RunTally(const Frame& start);

  double initial_mass = 0;        ///< of the bodies [kg]
  double breaking_time = kNever;  ///< end of the first step with a fragment [s]
  double peak_utilization = 0;
  double least_scaling = 1;  ///< least factor of any scaled impact
  int trouble = 0;           ///< unconverged solves, inverted tets and values that were not finite, summed
  StepReport total;          ///< of all steps, by add_step()

  /// Takes in the step that led to `frame`.
  void add(const Frame& frame);
};

/// A run that is over.
struct EndOfRun {
  const Frame& frame;  ///< the last
  const RunTally& tally;
  std::vector<double> masses;  ///< of the pieces, ascending [kg]
};

/// Where an outcome is listed; statistics, expressions and records know all.
enum class OutcomeListing {
  main,       ///< in the tables of pages, and wherever else there are outcomes
  more,       ///< in CSV files and the plots of pages
  other_name  ///< nowhere: another outcome has the same value
};

/// A number that tells how a run came out, the same whenever the run is made.
struct OutcomeKind {
  std::string key;      ///< as in files and expressions: "largest_piece", "energy.contacts"
  std::string unit;     ///< "kg"; "-" for a ratio, "" for a count
  std::string meaning;  ///< a phrase
  OutcomeListing listing = OutcomeListing::main;
  std::function<double(const EndOfRun& run)> value;
};

/// All outcomes, in the order in which tables show them. A new one is an entry of the table in outcome.cpp, a counter
/// (sim/world/step_counters.cpp) or an entry of the energy account.
std::span<const OutcomeKind> outcome_kinds();

/// The index of an outcome by its key. Throws InputError, which names `where` and the key most alike.
std::size_t outcome_index(std::string_view key, const std::string& where);

/// One value for each of outcome_kinds(), in their order.
using Outcomes = std::vector<double>;

/// The outcomes of a run that ends with `frame`.
Outcomes outcomes_of(const Frame& frame, const RunTally& tally);

}  // namespace griffith::app
