#include "app/study/find_report.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "app/shared/processes.h"
#include "app/shared/text_table.h"
#include "sim/core/number_text.h"

namespace griffith::app {
namespace {

using Report = nlohmann::ordered_json;

std::map<double, bool> verdicts(const Trials& trials) {
  std::map<double, bool> verdicts;
  for (const auto& [value, trial] : trials) verdicts[value] = trial.holds();
  return verdicts;
}

/// Describes a trial: "yes, pieces 12" or, for several runs, "7/20 = 0.35 [0.18, 0.57], pieces 12".
std::string seen(const Find& find, std::size_t condition, const Trial& trial) {
  const Proportion& proportion = trial.proportions[condition];
  std::string text = proportion.successes > 0 ? "yes" : "no";
  if (proportion.trials > 1) {
    const ConfidenceInterval interval = wilson_interval(proportion);
    char line[96];
    std::snprintf(line, sizeof line, "%d/%d = %.2f [%.2f, %.2f]", proportion.successes, proportion.trials,
                  proportion.estimate(), interval.low, interval.high);
    text = line;
  }
  for (const Comparison& part : find.conditions[condition].expression.comparisons)
    text.append(", ")
        .append(outcome_kinds()[part.outcome].key)
        .append(" ")
        .append(rounded_text(trial.median(condition, part.outcome), 5));
  return text;
}

std::string trial_table(const Find& find, const Trials& trials) {
  std::vector<std::vector<std::string>> lines = {{find.pointer.substr(1)}};
  for (const Condition& condition : find.conditions) lines[0].push_back(condition.text);
  for (const auto& [value, trial] : trials) {
    std::vector<std::string>& line = lines.emplace_back(1, number_text(value));
    for (std::size_t i = 0; i < find.conditions.size(); ++i) line.push_back(seen(find, i, trial));
  }
  return text_table(lines);
}

/// Returns a condition that holds on one side of the flip alone.
const Condition& deciding_condition(const Find& find, const Trial& below, const Trial& above) {
  for (std::size_t i = 0; i < find.conditions.size(); ++i)
    if (below.proportions[i].mostly() != above.proportions[i].mostly()) return find.conditions[i];
  return find.conditions.front();
}

/// Describes a flip: "fails at 11.25, holds at 11.3", with the commands that open the first run of both.
std::string flip_text(const Find& find, const Trials& trials, const Bracket& flip) {
  const bool above_holds = trials.at(flip.above).holds();
  std::string text = (above_holds ? "fails at " : "holds at ") + number_text(flip.below) +
                     (above_holds ? ", holds at " : ", fails at ") + number_text(flip.above) + "\n";
  const Condition& condition = deciding_condition(find, trials.at(flip.below), trials.at(flip.above));
  for (const double value : {flip.below, flip.above})
    text += "  " + shell_command(editor_words(find.request(value, condition, 0))) + "\n";
  return text;
}

std::string intervals_text(const Trials& trials) {
  const std::vector<HoldingInterval> intervals = holding_intervals(trials);
  if (intervals.empty()) return "the conditions hold at no tried value\n";
  std::string text = "holds";
  for (std::size_t i = 0; i < intervals.size(); ++i) {
    const auto [low, high] = intervals[i];
    text += i > 0 ? " and" : "";
    text += low == high ? " at " + number_text(low) : " from " + number_text(low) + " to " + number_text(high);
    if (high == trials.rbegin()->first && low != high) text += ", the highest tried";
  }
  return text + "\n";
}

/// Names the conditions that failed at all values.
std::string obstacles_text(const Find& find, const Trials& trials) {
  std::string text;
  for (std::size_t i = 0; i < find.conditions.size(); ++i) {
    int failures = 0;
    for (const auto& [value, trial] : trials) failures += !trial.proportions[i].mostly();
    if (failures > 0)
      text += "  \"" + find.conditions[i].text + "\" fails at " + std::to_string(failures) + " of " +
              std::to_string(trials.size()) + " values\n";
  }
  return text;
}

Report trial_json(const Find& find, double value, const Trial& trial) {
  Report json = {{"value", value}, {"holds", trial.holds()}, {"conditions", Report::array()}};
  for (std::size_t i = 0; i < trial.proportions.size(); ++i) {
    const ConfidenceInterval interval = wilson_interval(trial.proportions[i]);
    Report condition = {{"successes", trial.proportions[i].successes},
                        {"trials", trial.proportions[i].trials},
                        {"probability", trial.proportions[i].estimate()},
                        {"confidence_95", {interval.low, interval.high}}};
    for (const Comparison& part : find.conditions[i].expression.comparisons) {
      const double outcome = trial.median(i, part.outcome);
      condition[std::string(outcome_kinds()[part.outcome].key)] = std::isfinite(outcome) ? Report(outcome) : Report();
    }
    json["conditions"].push_back(std::move(condition));
  }
  return json;
}

}  // namespace

std::vector<HoldingInterval> holding_intervals(const Trials& trials) {
  std::vector<HoldingInterval> intervals;
  bool before = false;
  for (const auto& [value, trial] : trials) {
    const bool holds = trial.holds();
    if (holds && !before) intervals.push_back({value, value});
    if (holds) intervals.back().high = value;
    before = holds;
  }
  return intervals;
}

std::string find_text(const Find& find, const Trials& trials) {
  std::string text = trial_table(find, trials);
  if (find.repeats.runs.size() > 1)
    text += "of " + std::to_string(find.repeats.runs.size()) +
            " runs each, with Wilson's 95 % interval and medians; a condition holds if it does in at least half of the "
            "runs\n";
  text += "\n" + intervals_text(trials);
  const std::vector<Bracket> flips = flips_among(verdicts(trials));
  if (flips.size() > 1)
    text += "there are " + std::to_string(flips.size()) + " changes: there is no single threshold\n";
  for (const Bracket& flip : flips) text += flip_text(find, trials, flip);
  if (flips.empty() && !trials.begin()->second.holds()) text += obstacles_text(find, trials);
  return text;
}

std::string find_json(const Find& find, const Trials& trials) {
  const std::vector<Bracket> flips = flips_among(verdicts(trials));
  Report json = {{"scene", find.definition.scene.string()},
                 {"frames", find.definition.frames},
                 {"parameter", find.pointer},
                 {"conditions", find.definition.conditions},
                 {"monotone", flips.size() <= 1},
                 {"holds", Report::array()},
                 {"flips", Report::array()},
                 {"tried", Report::array()}};
  for (const auto& [low, high] : holding_intervals(trials)) json["holds"].push_back({low, high});
  for (const Bracket& flip : flips)
    json["flips"].push_back(
        {{"below", flip.below}, {"above", flip.above}, {"above_holds", trials.at(flip.above).holds()}});
  for (const auto& [value, trial] : trials) json["tried"].push_back(trial_json(find, value, trial));
  return json.dump(2, ' ', false, Report::error_handler_t::replace) + "\n";
}

}  // namespace griffith::app
