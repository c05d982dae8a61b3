#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "app/study/run_request.h"

namespace griffith::app {

/// Definition of a benchmark: the same runs with each number of threads.
struct BenchDefinition {
  std::vector<std::filesystem::path> scenes;
  std::vector<SceneSetting> settings;  ///< for all scenes
  std::vector<int> threads = {1, 2};
  int frames = 120;
  int repeats = 3;
};

/// Milliseconds of one step, over all steps of a run.
struct StepTimes {
  double median = 0, p99 = 0, longest = 0, mean = 0;
};

/// Measurements of a scene with one number of threads. Times are the minimum of all repeats, since other load only adds
/// to them; everything else is the same in each.
struct BenchResult {
  std::filesystem::path scene;
  int threads = 1;
  std::int64_t tets = 0, pieces = 0;  ///< at the end
  double loading_seconds = 0;         ///< time of the process without its steps
  std::int64_t memory_bytes = 0;      ///< peak, minus that of the program with an empty scene
  int iterations = 0;                 ///< maximum of the implicit solver over all steps
  double residual = 0;                ///< relative, maximum of all steps [-]
  std::string state_hash;
  std::vector<std::pair<std::string, StepTimes>> times;  ///< by phase as in `simulate --stats`, the whole step first
};

/// Makes all runs one after the other, each as a process of its own, until `cancelled` returns true. Throws InputError
/// for an unreadable scene, and std::runtime_error if a run fails or its final state differs from an earlier one of the
/// same scene: it must not depend on the number of threads.
std::vector<BenchResult> run_bench(const BenchDefinition& bench, const std::function<bool()>& cancelled);

/// Formats the results as lines for people, and as a JSON array with all values.
std::string bench_table(const std::vector<BenchResult>& results);
std::string bench_json(const BenchDefinition& bench, const std::vector<BenchResult>& results);

}  // namespace griffith::app
