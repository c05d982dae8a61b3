#pragma once

#include <string>

namespace griffith::app {

/// Appends a comma and the shortest text that reads back as the same double; only the comma if the value is not finite.
void append_csv_number(std::string& csv, double value);
/// Returns the text as a field of a CSV file (RFC 4180), quoted if necessary. An apostrophe is prefixed to text that
/// spreadsheets would take for a formula.
std::string csv_field(const std::string& text);

}  // namespace griffith::app
