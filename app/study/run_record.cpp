#include "app/study/run_record.h"

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "sim/core/error.h"
#include "sim/scene/json_document.h"

namespace griffith::app {
namespace {

using Record = nlohmann::ordered_json;

/// Returns null for a time that never came, and a text for NaN.
Record outcome_json(double value) {
  if (std::isnan(value)) return "nan";
  if (value == -kNever) return "-inf";
  return std::isfinite(value) ? Record(value) : Record();
}

double outcome_in(const Record& outcomes, const OutcomeKind& kind, const std::string& where) {
  const auto found = outcomes.find(kind.key);
  if (found != outcomes.end() && *found == "nan") return std::numeric_limits<double>::quiet_NaN();
  if (found != outcomes.end() && *found == "-inf") return -kNever;
  if (found == outcomes.end() || !(found->is_number() || found->is_null()))
    throw InputError(where, "lacks the outcome \"" + std::string(kind.key) + "\"",
                     "it is from another version of the program: remove it to repeat the run");
  return found->is_null() ? kNever : found->get<double>();
}

}  // namespace

std::string record_json(const RunRecord& record) {
  Record json;
  if (!record.error.empty()) {
    json["error"] = record.error;
  } else {
    for (std::size_t i = 0; i < record.outcomes.size(); ++i)
      json["outcomes"][std::string(outcome_kinds()[i].key)] = outcome_json(record.outcomes[i]);
  }
  return json.dump(2, ' ', false, Record::error_handler_t::replace) + "\n";
}

RunRecord record_from_json(const std::string& text, const std::string& where) {
  std::vector<InputError> problems;
  const Record json = parse_json(text, where, problems);
  RunRecord record;
  if (problems.empty() && json.is_object() && json.contains("error") && json["error"].is_string()) {
    record.error = json["error"];
    return record;
  }
  if (!problems.empty() || !json.is_object() || !json.contains("outcomes") || !json["outcomes"].is_object())
    throw InputError(where, "is not the record of a run", "remove it to repeat the run");
  for (const OutcomeKind& kind : outcome_kinds()) record.outcomes.push_back(outcome_in(json["outcomes"], kind, where));
  return record;
}

}  // namespace griffith::app
