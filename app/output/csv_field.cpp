#include "app/output/csv_field.h"

#include <cmath>
#include <string_view>

#include "sim/core/number_text.h"
#include "sim/mesh/file_cursor.h"

namespace griffith::app {

void append_csv_number(std::string& csv, double value) {
  csv += ',';
  if (std::isfinite(value)) append_number(csv, value);
}

namespace {

/// True if a spreadsheet would take the text for a formula rather than a number.
bool is_formula(const std::string& text) {
  double number = 0;
  return !text.empty() && std::string_view("=+-@\t\r").find(text.front()) != std::string_view::npos &&
         !parse_number(text, number);
}

}  // namespace

std::string csv_field(const std::string& text) {
  if (is_formula(text)) return csv_field("'" + text);
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted.append(c == '"' ? 2 : 1, c);
  return quoted + "\"";
}

}  // namespace griffith::app
