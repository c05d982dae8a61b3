#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "app/shared/flip_search.h"
#include "app/study/expression.h"
#include "app/study/proportion.h"
#include "app/study/run_request.h"
#include "app/study/sweep_plan.h"
#include "app/study/sweep_runs.h"

namespace griffith::app {

/// Definition of a search, as given by the user.
struct FindDefinition {
  std::filesystem::path scene;
  int frames = 0;
  std::vector<std::string> set;         ///< "POINTER=VALUE", for all runs
  std::string parameter;                ///< "POINTER", "POINTER=LOW:HIGH" or "POINTER=VALUE,VALUE,..."
  std::vector<std::string> conditions;  ///< as for read_condition(); at least one
  std::vector<std::string> vary;        ///< as for read_parameter(); each value is tried with all their combinations
  int seeds = 0;                        ///< number of seeds of the random strength; 0: unchanged
  int points = 5;                       ///< values over the range before bisection
  double tolerance = 0.01;              ///< as in FlipSearch
};

/// A search that is ready to run.
struct Find {
  FindDefinition definition;
  std::vector<SceneSetting> settings;
  std::string pointer;
  std::vector<double> values;  ///< initial values; a single one, from which the range is widened, if no range is given
  bool narrow = true;          ///< true if flips between them are bisected
  std::vector<Condition> conditions;
  SweepPlan repeats;  ///< one run, or those made with every value
  FlipSearch search;
  std::filesystem::path program;

  /// Returns the run that decides a condition. `repeat`: index into the runs of `repeats`.
  RunRequest request(double value, const Condition& condition, std::size_t repeat) const;
};

/// Makes a search. Throws InputError for input that cannot be read.
Find make_find(const FindDefinition& definition, const JobLimits& job_limits);

/// Results at a value of the parameter.
struct Trial {
  std::vector<Proportion> proportions;          ///< fraction of runs in which the condition holds, by condition
  std::vector<std::vector<Outcomes>> outcomes;  ///< by condition, then repeat

  /// True if each condition holds in at least half of its runs.
  bool holds() const;
  /// Returns the median of an outcome over a condition's runs.
  double median(std::size_t condition, std::size_t outcome) const;
};

using Trials = std::map<double, Trial>;

/// Tries values in separate processes and bisects flips. Throws std::runtime_error if a run fails.
Trials find(const Find& find, const JobLimits& job_limits);

}  // namespace griffith::app
