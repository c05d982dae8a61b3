#pragma once

#include <charconv>
#include <cmath>
#include <cstdio>
#include <optional>
#include <string>
#include <string_view>

#include "sim/core/linear_algebra.h"

namespace griffith {

/// Appends the shortest text that reads back as the same number.
template <class T>
void append_number(std::string& text, T value) {
  char digits[32];
  text.append(digits, std::to_chars(digits, digits + sizeof digits, value).ptr);
}

/// Appends the number, then `end`.
template <class T>
void append_number(std::string& text, T value, char end) {
  append_number(text, value);
  text += end;
}

/// Returns the shortest text that reads back as the same number.
inline std::string number_text(double value) {
  std::string text;
  append_number(text, value);
  return text;
}

/// Returns the finite number that fills a text; empty for other texts.
inline std::optional<double> number_in(std::string_view text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool good = error == std::errc() && end == text.data() + text.size() && std::isfinite(value);
  return good ? std::optional(value) : std::nullopt;
}

/// Returns a number rounded to at most `digits` significant digits: "0.25", "1e+06".
inline std::string rounded_text(double value, int digits) {
  char text[32];
  std::snprintf(text, sizeof text, "%.*g", digits, value);
  return text;
}

/// Returns a count with separators: "8,012".
inline std::string count_text(long long count) {
  std::string digits = std::to_string(count);
  const std::size_t first = count < 0 ? 1 : 0;
  for (std::size_t at = digits.size(); at > first + 3;) digits.insert(at -= 3, 1, ',');
  return digits;
}

/// Returns a position as text: "(1, 0.25, -2)".
inline std::string place_text(const Vec3& place) {
  char text[96];
  std::snprintf(text, sizeof text, "(%.6g, %.6g, %.6g)", place.x(), place.y(), place.z());
  return text;
}

}  // namespace griffith
