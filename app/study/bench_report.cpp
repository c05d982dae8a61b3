#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "app/shared/text_table.h"
#include "app/study/bench.h"

namespace griffith::app {
namespace {

using Json = nlohmann::ordered_json;

std::string number(double value, const char* format = "%.3g") {
  char text[32];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

std::string bytes_a_tet(const BenchResult& result) {
  return result.tets == 0 ? "" : std::to_string(result.memory_bytes / result.tets);
}

std::vector<std::string> heading(const BenchResult& first) {
  std::vector<std::string> cells = {"scene", "tets", "pieces", "threads", "median", "99 %", "longest"};
  for (std::size_t i = 1; i < first.times.size(); ++i) cells.push_back(first.times[i].first);
  for (const char* cell : {"iterations", "residual", "loading s", "MB", "bytes/tet"}) cells.emplace_back(cell);
  return cells;
}

std::vector<std::string> row(const BenchResult& result) {
  const StepTimes& step = result.times.at(0).second;
  std::vector<std::string> cells = {result.scene.stem().string(),  std::to_string(result.tets),
                                    std::to_string(result.pieces), std::to_string(result.threads),
                                    number(step.median, "%.2f"),   number(step.p99, "%.2f"),
                                    number(step.longest, "%.2f")};
  for (std::size_t i = 1; i < result.times.size(); ++i) cells.push_back(number(result.times[i].second.mean, "%.2f"));
  cells.push_back(std::to_string(result.iterations));
  cells.push_back(number(result.residual, "%.1e"));
  cells.push_back(number(result.loading_seconds, "%.2f"));
  cells.push_back(number(static_cast<double>(result.memory_bytes) / (1 << 20), "%.1f"));
  cells.push_back(bytes_a_tet(result));
  return cells;
}

Json json_of(const BenchResult& result) {
  Json json = {{"scene", result.scene.string()},
               {"threads", result.threads},
               {"tets", result.tets},
               {"pieces", result.pieces},
               {"loading_seconds", result.loading_seconds},
               {"memory_bytes", result.memory_bytes},
               {"solver_iterations", result.iterations},
               {"max_relative_residual", result.residual},
               {"state_hash", result.state_hash}};
  for (const auto& [phase, ms] : result.times)
    json["ms"][phase] = {{"median", ms.median}, {"p99", ms.p99}, {"max", ms.longest}, {"mean", ms.mean}};
  return json;
}

}  // namespace

std::string bench_table(const std::vector<BenchResult>& results) {
  if (results.empty()) return {};
  std::vector<std::vector<std::string>> lines = {heading(results[0])};
  for (const BenchResult& result : results) lines.push_back(row(result));
  return text_table(lines) +
         "Milliseconds per step: median, 99th percentile and maximum of whole steps; mean of phases and processor "
         "time.\n";
}

std::string bench_json(const BenchDefinition& bench, const std::vector<BenchResult>& results) {
  Json json = {{"frames", bench.frames}, {"repeats", bench.repeats}, {"runs", Json::array()}};
  for (const BenchResult& result : results) json["runs"].push_back(json_of(result));
  return json.dump(2) + "\n";
}

}  // namespace griffith::app
