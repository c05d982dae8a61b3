#include "app/output/replay_report.h"

#include <cstdio>

namespace griffith::app {
namespace {

std::string steps_text(std::int64_t steps) { return std::to_string(steps) + (steps == 1 ? " step" : " steps"); }

std::string joined(const std::vector<std::string_view>& names) {
  std::string list;
  for (const std::string_view name : names) list.append(list.empty() ? "" : ", ").append(name);
  return list;
}

}  // namespace

std::string replay_report(const Recording& recording, const Replay& replay) {
  const auto& difference = replay.difference();
  if (!difference) return steps_text(recording.steps()) + " equal\n";
  const std::string place =
      difference->step == 0 ? "the start differs" : "step " + std::to_string(difference->step) + " differs first";
  std::string report = place + " (of " + steps_text(recording.steps()) + "), in: " + joined(difference->fields) + "\n";
  const std::string rows = version_differences(recording.versions, versions_here());
  if (rows.empty()) return report + "Both runs were made by the same build on the same kind of machine.\n";
  return report + "Differences of the programs, first the recording's, then this one's:\n" + rows;
}

}  // namespace griffith::app
