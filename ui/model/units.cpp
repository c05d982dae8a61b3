#include "ui/model/units.h"

#include <array>
#include <cmath>
#include <cstdio>

namespace griffith::ui {
namespace {

constexpr std::array<SiPrefix, 8> kPrefixes = {
    {{1e-9, "n"}, {1e-6, "µ"}, {1e-3, "m"}, {1, ""}, {1e3, "k"}, {1e6, "M"}, {1e9, "G"}, {1e12, "T"}}};

}  // namespace

std::span<const SiPrefix> si_prefixes() { return kPrefixes; }

bool takes_prefix(std::string_view unit) {
  return unit == "Pa" || unit == "N" || unit == "J" || unit == "m" || unit == "Pa·√m" || unit == "Hz";
}

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
  return format_quantity(value, unit, si_prefix(value, unit), digits);
}

std::string format_quantity(double value, std::string_view unit, const SiPrefix& prefix, int digits) {
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

}  // namespace griffith::ui
