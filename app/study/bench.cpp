#include "app/study/bench.h"

#include <algorithm>
#include <chrono>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>

#include "app/shared/processes.h"
#include "app/shared/progress.h"
#include "sim/core/read_file.h"
#include "sim/core/replace_file.h"
#include "sim/core/temporary_folder.h"
#include "sim/scene/scene_reader.h"

namespace griffith::app {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
using Clock = std::chrono::steady_clock;

/// Output of a run of `simulate` and its resource usage.
struct TimedRun {
  Json statistics;
  double seconds = 0;
};

/// Makes a run. Empty if it was cancelled.
std::optional<TimedRun> timed_run(const RunRequest& request, int threads, const fs::path& folder,
                                  const std::function<bool()>& cancelled) {
  const fs::path file = folder / "stats.json";
  std::vector<std::string> words = with_scene({request.program.string(), "simulate"}, request);
  for (const std::string& word : {std::string("--frames"), std::to_string(request.frames), std::string("--threads"),
                                  std::to_string(threads), std::string("--stats"), file.string()})
    words.push_back(word);
  constexpr ProcessLimits kLimits = {1e9, std::numeric_limits<std::int64_t>::max()};
  const Clock::time_point start = Clock::now();
  const ProcessOutcome outcome = run_process(words, kLimits, {}, cancelled);
  const std::chrono::duration<double> seconds = Clock::now() - start;
  if (outcome.end == ProcessOutcome::End::cancelled) return std::nullopt;
  if (!outcome.succeeded()) throw std::runtime_error(request.scene.string() + ": " + failure_text(outcome, kLimits));
  return TimedRun{Json::parse(read_file(file)), seconds.count()};
}

std::vector<std::pair<std::string, StepTimes>> step_times(const Json& statistics) {
  const double steps = std::max(1.0, statistics.at("frames").get<double>());
  std::vector<std::pair<std::string, StepTimes>> times;
  for (const auto& [phase, ms] : statistics.at("ms").items())
    times.push_back({phase, {ms.at("median"), ms.at("p99"), ms.at("max"), ms.at("total").get<double>() / steps}});
  return times;
}

BenchResult result_of(const TimedRun& run, const fs::path& scene, std::int64_t memory_without_scene) {
  const Json& s = run.statistics;
  BenchResult result;
  result.scene = scene;
  result.threads = s.at("threads");
  result.tets = s.at("tets");
  result.pieces = s.at("bodies");
  result.loading_seconds = run.seconds - 1e-3 * s.at("ms").at("step").at("total").get<double>();
  result.memory_bytes = std::max<std::int64_t>(s.at("peak_memory_bytes").get<std::int64_t>() - memory_without_scene, 0);
  result.iterations = s.at("solver_iterations");
  result.residual = s.at("max_relative_residual");
  result.state_hash = s.at("state_hash");
  result.times = step_times(s);
  return result;
}

void keep_least(const BenchResult& run, BenchResult& least) {
  least.loading_seconds = std::min(least.loading_seconds, run.loading_seconds);
  least.memory_bytes = std::min(least.memory_bytes, run.memory_bytes);
  for (std::size_t i = 0; i < least.times.size(); ++i)
    for (double StepTimes::*time : {&StepTimes::median, &StepTimes::p99, &StepTimes::longest, &StepTimes::mean})
      least.times[i].second.*time = std::min(least.times[i].second.*time, run.times[i].second.*time);
}

void expect_same_state(const BenchResult& result, const std::vector<BenchResult>& results) {
  for (const BenchResult& other : results)
    if (other.scene == result.scene && other.state_hash != result.state_hash)
      throw std::runtime_error(result.scene.string() + ": ends in state " + other.state_hash + " with " +
                               std::to_string(other.threads) + " threads, but in " + result.state_hash + " with " +
                               std::to_string(result.threads) + ". Results must not depend on it: please report this");
}

/// Returns the runs of each scene. An unreadable file is reported before any run.
std::vector<RunRequest> requests_of(const BenchDefinition& bench) {
  std::vector<RunRequest> requests;
  for (const fs::path& scene : bench.scenes) {
    RunRequest request{this_program(), scene, bench.settings, bench.frames};
    static_cast<void>(read_scene(scene, request.settings));
    requests.push_back(std::move(request));
  }
  return requests;
}

}  // namespace

std::vector<BenchResult> run_bench(const BenchDefinition& bench, const std::function<bool()>& cancelled) {
  const std::vector<RunRequest> requests = requests_of(bench);
  const TemporaryFolder folder;
  const fs::path empty = folder.path() / "empty.json";
  replace_file(empty, R"({"version": 1})");
  const std::optional<TimedRun> without = timed_run({this_program(), empty, {}, 1}, 1, folder.path(), cancelled);
  if (!without) return {};
  const auto memory = without->statistics.at("peak_memory_bytes").get<std::int64_t>();
  const auto runs = static_cast<int>(requests.size() * bench.threads.size()) * bench.repeats;
  Progress progress("Timing", runs);
  int done = 0;
  std::vector<BenchResult> results;
  for (const RunRequest& request : requests)
    for (const int threads : bench.threads)
      for (int repeat = 0; repeat < bench.repeats; ++repeat) {
        const std::optional<TimedRun> run = timed_run(request, threads, folder.path(), cancelled);
        if (!run) return results;
        const BenchResult result = result_of(*run, request.scene, memory);
        expect_same_state(result, results);
        repeat == 0 ? results.push_back(result) : keep_least(result, results.back());
        progress.update(++done);
      }
  return results;
}

}  // namespace griffith::app
