#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "app/study/run_request.h"

namespace griffith::app {

/// What is timed: the same runs with each number of threads.
struct BenchDefinition {
  std::vector<std::filesystem::path> scenes;
  std::vector<SceneSetting> settings;  ///< of all scenes
  std::vector<int> threads = {1, 2};
  int frames = 120;
  int repeats = 3;
};

/// Milliseconds of one step, of all steps of a run.
struct StepTimes {
  double median = 0, p99 = 0, longest = 0, mean = 0;
};

/// What the runs of a scene with one number of threads took. Times are the least of all repeats, since whatever else
/// the machine does only adds to them; everything else is the same in each.
struct BenchResult {
  std::filesystem::path scene;
  int threads = 1;
  std::int64_t tets = 0, pieces = 0;  ///< after the last step
  double loading_seconds = 0;         ///< of the process without its steps
  std::int64_t memory_bytes = 0;      ///< peak, beyond that of the program with an empty scene
  int iterations = 0;                 ///< of the implicit solver, most in any step
  double residual = 0;                ///< relative, largest in any step [-]
  std::string state_hash;
  std::vector<std::pair<std::string, StepTimes>> times;  ///< by phase as in `simulate --stats`, the whole step first
};

/// Makes all runs, one after the other, each as a process of its own, until `cancelled` says so. Throws InputError for
/// a scene that cannot be read, and std::runtime_error where a run fails, or ends in another state than one before it
/// of the same scene: with other threads too it has to be the same.
std::vector<BenchResult> run_bench(const BenchDefinition& bench, const std::function<bool()>& cancelled);

/// The results as lines for a person, and as a JSON array with all that is known.
std::string bench_table(const std::vector<BenchResult>& results);
std::string bench_json(const BenchDefinition& bench, const std::vector<BenchResult>& results);

}  // namespace griffith::app
