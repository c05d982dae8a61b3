#pragma once

#include <string>

namespace griffith::app {

/// Appends a comma and the shortest text that reads back as the same double; nothing behind the comma where it is not
/// finite.
void append_csv_number(std::string& csv, double value);
/// The text as a field of a CSV file (RFC 4180): in quotation marks where it would not be one field without them. What
/// spreadsheets take for a formula has an apostrophe before it, which keeps them from it.
std::string csv_field(const std::string& text);

}  // namespace griffith::app
