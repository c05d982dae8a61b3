#include "ui/model/units.h"

#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>

namespace griffith::ui {
namespace {

constexpr std::array<SiPrefix, 8> kPrefixes = {
    {{1e-9, "n"}, {1e-6, "µ"}, {1e-3, "m"}, {1, ""}, {1e3, "k"}, {1e6, "M"}, {1e9, "G"}, {1e12, "T"}}};

bool takes_prefix(std::string_view unit) {
  return unit == "Pa" || unit == "N" || unit == "J" || unit == "m" || unit == "Pa·√m" || unit == "Hz";
}

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

/// The factor that `suffix` ("GPa", "G", "Pa", "u") stands for.
std::optional<double> suffix_factor(std::string_view suffix, std::string_view unit) {
  if (suffix == unit) return 1.0;
  for (const SiPrefix& prefix : kPrefixes) {
    const bool micro = prefix.symbol == "µ" && suffix.starts_with("u");
    if (!takes_prefix(unit) || prefix.symbol.empty() || !(micro || suffix.starts_with(prefix.symbol))) continue;
    const std::string_view rest = suffix.substr(micro ? 1 : prefix.symbol.size());
    if (rest.empty() || rest == unit) return prefix.factor;
  }
  return std::nullopt;
}

}  // namespace

SiPrefix si_prefix(double value, std::string_view unit) {
  const double magnitude = std::abs(value);
  if (!takes_prefix(unit) || magnitude == 0 || !std::isfinite(magnitude)) return {};
  SiPrefix best;  // what is below the table is written with an exponent instead
  for (const SiPrefix& prefix : kPrefixes) {
    if (magnitude >= prefix.factor * (1 - 1e-12)) best = prefix;
  }
  return best;
}

std::string format_number(double value, const SiPrefix& prefix, int digits) {
  std::array<char, 64> number;
  const double scaled = value / prefix.factor;
  // From 1000 on %g would switch to an exponent for few digits.
  if (std::abs(scaled) >= 1000 && std::abs(scaled) < 1e6) {
    std::snprintf(number.data(), number.size(), "%.0f", scaled);
  } else {
    std::snprintf(number.data(), number.size(), "%.*g", digits, scaled);
  }
  return number.data();
}

std::string format_quantity(double value, std::string_view unit, int digits) {
  const SiPrefix prefix = si_prefix(value, unit);
  std::string text = format_number(value, prefix, digits);
  if (unit.empty() || unit == "-") return text;
  if (unit != "°") text += ' ';
  return text.append(prefix.symbol).append(unit);
}

std::string direction_text(const Vec3& direction) {
  char text[48];
  std::snprintf(text, sizeof text, "%.2f, %.2f, %.2f", direction.x(), direction.y(), direction.z());
  return text;
}

std::string_view unit_symbol(const Numbers& numbers) {
  if (numbers.unit == "degrees") return "°";
  return numbers.unit == "-" ? "" : numbers.unit;
}

std::string range_text_with_prefix(const Numbers& numbers) {
  const std::string_view unit = unit_symbol(numbers);
  return format_quantity(numbers.minimum, unit) + " to " + format_quantity(numbers.maximum, unit);
}

std::string clamped_note(double typed, const Numbers& numbers) {
  const std::string_view unit = unit_symbol(numbers);
  const bool high = typed > numbers.maximum;
  return format_quantity(typed, unit, 6) + (high ? " is more than " : " is less than ") +
         format_quantity(high ? numbers.maximum : numbers.minimum, unit) +
         " and was set to it: " + range_text_with_prefix(numbers) + " is possible.";
}

std::optional<double> parse_quantity(std::string_view text, std::string_view unit) {
  text = trimmed(text);
  if (text.starts_with('+')) text.remove_prefix(1);
  double number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || !std::isfinite(number)) return std::nullopt;
  const std::string_view suffix = trimmed(text.substr(static_cast<std::size_t>(end - text.data())));
  if (suffix.empty()) return number;
  const std::optional<double> factor = suffix_factor(suffix, unit);
  if (!factor) return std::nullopt;
  return number * *factor;
}

}  // namespace griffith::ui
