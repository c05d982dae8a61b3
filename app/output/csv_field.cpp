#include "app/output/csv_field.h"

#include <cmath>

#include "sim/mesh/number_text.h"

namespace griffith::app {

void append_csv_number(std::string& csv, double value) {
  csv += ',';
  if (std::isfinite(value)) append_number(csv, value);
}

std::string csv_field(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted.append(c == '"' ? 2 : 1, c);
  return quoted + "\"";
}

}  // namespace griffith::app
