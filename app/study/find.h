#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "app/study/expression.h"
#include "app/study/flip_search.h"
#include "app/study/proportion.h"
#include "app/study/run_request.h"
#include "app/study/sweep_plan.h"
#include "app/study/sweep_runs.h"

namespace griffith::app {

/// What is looked for, as its user says it.
struct FindDefinition {
  std::filesystem::path scene;
  int frames = 0;
  std::vector<std::string> set;         ///< "POINTER=VALUE", for all runs
  std::string parameter;                ///< "POINTER", "POINTER=LOW:HIGH" or "POINTER=VALUE,VALUE,..."
  std::vector<std::string> conditions;  ///< as read_condition() takes them; one at least
  std::vector<std::string> vary;        ///< as read_parameter(): each value is tried with all of their combinations
  int seeds = 0;                        ///< and with so many seeds of the random strength; 0: left as they are
  int points = 5;                       ///< values over the range before it is narrowed
  double tolerance = 0.01;              ///< as of FlipSearch
};

/// A search that is ready to go.
struct Find {
  FindDefinition definition;
  std::vector<SceneSetting> settings;
  std::string pointer;
  std::vector<double> values;  ///< to try at first; one, from which the range is widened, where none was given
  bool narrow = true;          ///< whether flips between them are narrowed down
  std::vector<Condition> conditions;
  SweepPlan repeats;  ///< one run, or those that every value is tried with
  FlipSearch search;
  std::filesystem::path program;

  /// The run that a condition is judged by. `repeat`: index into the runs of `repeats`.
  RunRequest request(double value, const Condition& condition, std::size_t repeat) const;
};

/// Throws InputError for what cannot be read.
Find make_find(const FindDefinition& definition, const Effort& effort);

/// What was seen at a value of the parameter.
struct Trial {
  std::vector<Proportion> proportions;          ///< of runs in which the condition holds, by condition
  std::vector<std::vector<Outcomes>> outcomes;  ///< by condition, then repeat

  /// Whether each condition holds in at least half of its runs.
  bool holds() const;
  /// The median of an outcome in a condition's runs.
  double median(std::size_t condition, std::size_t outcome) const;
};

using Trials = std::map<double, Trial>;

/// Tries values, in processes of their own, and narrows flips down. Throws std::runtime_error when a run fails.
Trials find(const Find& find, const Effort& effort);

}  // namespace griffith::app
