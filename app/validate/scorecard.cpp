#include "app/validate/scorecard.h"

#include <cmath>
#include <set>
#include <sstream>

#include "sim/core/number_text.h"

namespace griffith::app {
namespace {

constexpr const char* kIntroduction =
    "# Scorecard\n\n"
    "Published experiments and closed forms of fracture, repeated by the program on up to three meshes each. `griffith "
    "validate`\nwrites this page; `griffith validate NAME --out docs/scorecard.md` replaces the part of one "
    "experiment. "
    "Each states before\nits run what it accepts. *Spread* is half the range of a quantity over all meshes and "
    "variants, "
    "over its middle. Values\noutside the accepted range are bold. [Validation](validation.md) compares elements, "
    "waves "
    "and motion with closed forms.\n\n";

std::string mark(bool passes) { return passes ? "🟢 pass" : "🔴 **fail**"; }

std::string value_text(double value) { return std::isnan(value) ? "none" : rounded_text(value, 3); }

std::string range_text(const AcceptedRange& range) {
  if (std::isinf(range.low) && std::isinf(range.high)) return "any";
  if (std::isinf(range.low)) return "≤ " + rounded_text(range.high, 3);
  if (std::isinf(range.high)) return "≥ " + rounded_text(range.low, 3);
  return rounded_text(range.low, 3) + " – " + rounded_text(range.high, 3);
}

/// Result in one line: "fail: 3 of 9 values are outside: …".
std::string result_text(const Judgment& judgment) {
  std::size_t values = 0;
  for (const Measurement& measurement : judgment.measurements) values += measurement.values.size();
  if (judgment.passes()) return "all " + std::to_string(values) + " values and their spreads are accepted";
  std::string text = std::to_string(judgment.outside) + " of " + std::to_string(values) + " values are outside";
  if (judgment.spread_out > 0)
    text += ", the spread of " + std::to_string(judgment.spread_out) +
            (judgment.spread_out == 1 ? " quantity is" : " quantities is") + " too large";
  return text + ": " + judgment.worst;
}

std::string spread_text(const Judgment& judgment, const Reading& reading) {
  if (reading.largest_spread == 0) return "";
  const double spread = spread_of(judgment.measurements, reading.quantity);
  if (std::isnan(spread)) return "none";
  const std::string text = "± " + percent_text(spread);
  return spread > reading.largest_spread ? "**" + text + "**" : text;
}

/// Returns the table of all values. The spread of a quantity stands in its first row.
std::string values_table(const Experiment& experiment, const Judgment& judgment) {
  std::ostringstream text;
  text << "| quantity | variant | accepted |";
  for (const std::string& mesh : experiment.meshes) text << ' ' << mesh << " |";
  text << " spread |\n|---|---|---|";
  for (std::size_t mesh = 0; mesh < experiment.meshes.size(); ++mesh) text << "---|";
  text << "---|\n";
  std::set<std::string> seen;
  for (const auto& [reading, values] : judgment.measurements) {
    text << "| " << reading.quantity << " | " << reading.variant << " | " << range_text(reading.accepted) << " |";
    for (const double value : values)
      text << (reading.accepted.contains(value) ? " " + value_text(value) + " |" : " **" + value_text(value) + "** |");
    text << ' ' << (seen.insert(reading.quantity).second ? spread_text(judgment, reading) : "") << " |\n";
  }
  return text.str();
}

/// Returns the anchor of a heading, as GitHub makes it.
std::string anchor_of(const std::string& heading) {
  std::string anchor;
  for (const char c : heading)
    if (c == ' ')
      anchor += '-';
    else if (std::isalnum(static_cast<unsigned char>(c)) || c == '-' || c == '_' || static_cast<unsigned char>(c) > 127)
      anchor += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return anchor;
}

const std::string kBegin = "<!-- table ", kEnd = "<!-- end -->\n", kSummary = "scorecard";

std::string marked(const std::string& name, const std::string& text) { return kBegin + name + " -->\n" + text + kEnd; }

}  // namespace

ScorecardEntry scorecard_entry(const Experiment& experiment, const Judgment& judgment) {
  const std::string verdict = mark(judgment.passes());
  ScorecardEntry entry;
  entry.row = "| [" + experiment.key + "](#" + anchor_of(experiment.title) + ") | " + experiment.title + " | " +
              experiment.source + " | " + verdict + " | " + result_text(judgment) + " |";
  std::string text = "## " + experiment.title + "\n\n`griffith validate " + experiment.key +
                     "`. Source: " + experiment.source + ".\n\n" + experiment.measured +
                     "\n\nAccepted: " + experiment.acceptance + "\n\nResult: " + verdict + ", " +
                     result_text(judgment) + ".";
  if (!judgment.passes() && !experiment.cause.empty()) text += " " + experiment.cause;
  entry.section = text + "\n\n" + values_table(experiment, judgment);
  return entry;
}

std::string scorecard_page(const Scorecard& scorecard) {
  std::string rows = "| name | experiment | source | result | reason |\n|---|---|---|---|---|\n", sections;
  for (const Experiment& experiment : experiments()) {
    const auto entry = scorecard.find(experiment.key);
    if (entry == scorecard.end()) continue;
    rows += entry->second.row + "\n";
    sections += "\n" + marked(experiment.key, entry->second.section);
  }
  return kIntroduction + marked(kSummary, rows) + sections;
}

Scorecard read_scorecard(const std::string& page) {
  std::map<std::string, std::string> parts;
  for (std::size_t at = 0; (at = page.find(kBegin, at)) != std::string::npos;) {
    const std::size_t name = at + kBegin.size(), text = page.find('\n', at), end = page.find(kEnd, at);
    if (text == std::string::npos || end == std::string::npos) break;
    parts[page.substr(name, page.find(' ', name) - name)] = page.substr(text + 1, end - text - 1);
    at = end;
  }
  Scorecard scorecard;
  std::istringstream rows(parts[kSummary]);
  for (std::string row; std::getline(rows, row);) {
    const std::string key = row.starts_with("| [") ? row.substr(3, row.find(']') - 3) : "";
    if (parts.contains(key)) scorecard[key] = {row, parts[key]};
  }
  return scorecard;
}

}  // namespace griffith::app
