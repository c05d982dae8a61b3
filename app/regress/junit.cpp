#include <algorithm>
#include <cstdio>
#include <numeric>

#include "app/output/html_page.h"
#include "app/regress/report.h"

namespace griffith::app {
namespace {

std::string attribute(const std::string& name, const std::string& value) {
  return " " + name + "=\"" + escape_markup(value) + "\"";
}

std::string seconds_text(double seconds) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3f", seconds);
  return text;
}

/// Returns the failure or error of a picture; empty if it passed.
std::string outcome_xml(const PictureResult& result) {
  if (result.status == PictureStatus::passed) return "";
  const std::string element = result.status == PictureStatus::error ? "error" : "failure";
  const std::string first_line = result.reason.substr(0, result.reason.find('\n'));
  std::string details = result.reason;
  if (!result.accept_command.empty()) details += "\nAccept: " + result.accept_command;
  return "    <" + element + attribute("message", first_line) + attribute("type", status_name(result.status)) + ">" +
         escape_markup(details) + "</" + element + ">\n";
}

std::string case_xml(const std::string& suite, const PictureResult& result) {
  return "  <testcase" + attribute("classname", suite) + attribute("name", result.name) +
         attribute("time", seconds_text(result.seconds)) + ">\n" + outcome_xml(result) + "  </testcase>\n";
}

}  // namespace

std::string junit_xml(const std::string& suite, std::span<const PictureResult> results) {
  const auto count = [&](PictureStatus status) { return std::ranges::count(results, status, &PictureResult::status); };
  const double seconds = std::accumulate(results.begin(), results.end(), 0.0,
                                         [](double sum, const PictureResult& result) { return sum + result.seconds; });
  const std::string totals =
      attribute("name", suite) + attribute("tests", std::to_string(results.size())) +
      attribute("failures", std::to_string(count(PictureStatus::failed) + count(PictureStatus::missing_golden))) +
      attribute("errors", std::to_string(count(PictureStatus::error))) + attribute("skipped", "0") +
      attribute("time", seconds_text(seconds));
  std::string xml =
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites" + totals + ">\n<testsuite" + totals + ">\n";
  for (const PictureResult& result : results) xml += case_xml(suite, result);
  return xml + "</testsuite>\n</testsuites>\n";
}

}  // namespace griffith::app
