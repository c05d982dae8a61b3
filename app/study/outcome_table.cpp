#include "app/study/outcome_table.h"

#include <cmath>

#include "app/output/csv_field.h"
#include "sim/core/number_text.h"

namespace griffith::app {
namespace {

void append_row(std::string& csv, const Sweep& sweep, std::size_t run, const RunRecord& record) {
  csv += std::to_string(run + 1);
  for (const std::string& value : sweep.plan.runs[run]) csv += "," + csv_field(setting_word(value));
  for (std::size_t i = 0; i < outcome_kinds().size(); ++i) {
    if (outcome_kinds()[i].listing == OutcomeListing::other_name) continue;
    csv += ',';
    if (record.error.empty() && std::isfinite(record.outcomes[i])) append_number(csv, record.outcomes[i]);
  }
  csv += "," + csv_field(record.error) + "\n";
}

}  // namespace

std::string outcome_csv(const Sweep& sweep, const std::vector<std::optional<RunRecord>>& records) {
  std::string csv = "run";
  for (const Parameter& parameter : sweep.plan.parameters) csv += "," + csv_field(parameter.name);
  for (const OutcomeKind& kind : outcome_kinds()) {
    if (kind.listing == OutcomeListing::other_name) continue;
    csv.append(",").append(kind.key);
    if (!kind.unit.empty() && kind.unit != "-") csv.append(" [").append(kind.unit).append("]");
  }
  csv += ",error\n";
  for (std::size_t run = 0; run < records.size(); ++run)
    if (records[run]) append_row(csv, sweep, run, *records[run]);
  return csv;
}

}  // namespace griffith::app
