#include "ui/model/units.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <vector>

namespace griffith::ui {
namespace {

constexpr std::array<SiPrefix, 8> kPrefixes = {
    {{1e-9, "n"}, {1e-6, "µ"}, {1e-3, "m"}, {1, ""}, {1e3, "k"}, {1e6, "M"}, {1e9, "G"}, {1e12, "T"}}};

/// Returns the spellings of a unit without characters that keyboards lack.
std::vector<std::string_view> plain_spellings(std::string_view unit) {
  if (unit != "Pa·√m") return {unit};
  return {"Pa sqrt(m)", "Pa*sqrt(m)", "Pa.sqrt(m)", "Pa sqrt m", "Pa√m",      "Pa √m",
          "Pa m^0.5",   "Pa*m^0.5",   "Pa.m^0.5",   "Pa m^1/2",  "Pa m^(1/2)"};
}

bool takes_prefix(std::string_view unit) {
  return unit == "Pa" || unit == "N" || unit == "J" || unit == "m" || unit == "Pa·√m" || unit == "Hz";
}

/// Another spelling, or another unit of the same kind.
struct OtherUnit {
  std::string_view unit, spelling;
  double factor;  ///< units in one of the other
};

constexpr std::array kOtherUnits =
    std::to_array<OtherUnit>({{"", "%", 1e-2},          {"m³", "m^3", 1},
                              {"kg/m³", "kg/m^3", 1},   {"kg/m³", "g/cm^3", 1e3},
                              {"m/s²", "m/s^2", 1},     {"Pa", "N/mm²", 1e6},
                              {"Pa", "N/mm2", 1e6},     {"Pa", "N/mm^2", 1e6},
                              {"m", "cm", 1e-2},        {"m", "in", 0.0254},
                              {"m", "ft", 0.3048},      {"m³", "m3", 1},
                              {"s", "ms", 1e-3},        {"s", "µs", 1e-6},
                              {"s", "us", 1e-6},        {"s", "min", 60},
                              {"ms", "s", 1e3},         {"kg", "g", 1e-3},
                              {"kg", "t", 1e3},         {"kg/m³", "kg/m3", 1},
                              {"kg/m³", "g/cm³", 1e3},  {"kg/m³", "g/cm3", 1e3},
                              {"m/s", "km/h", 1 / 3.6}, {"m/s²", "m/s2", 1},
                              {"Pa", "bar", 1e5},       {"Pa", "psi", 6894.757293168},
                              {"°", "deg", 1},          {"°", "rad", 180 / std::numbers::pi},
                              {"MB", "GB", 1000}});

}  // namespace

SiPrefix si_prefix(double value, std::string_view unit) {
  const double magnitude = std::abs(value);
  if (!takes_prefix(unit) || magnitude == 0 || !std::isfinite(magnitude)) return {};
  SiPrefix best;  // values below the table are written with an exponent
  for (const SiPrefix& prefix : kPrefixes) {
    if (magnitude >= prefix.factor * (1 - 1e-12)) best = prefix;
  }
  return best;
}

std::string format_number(double value, const SiPrefix& prefix, int digits) {
  std::array<char, 64> number;
  const double scaled = value / prefix.factor;
  // Where there are more digits before the point than asked for, %g would write an exponent.
  if (std::abs(scaled) >= std::min(1000.0, std::pow(10, digits)) && std::abs(scaled) < 1e6) {
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
  return with_unit(format_number(value, prefix, digits), unit, prefix);
}

std::string with_unit(std::string number, std::string_view unit, const SiPrefix& prefix) {
  if (unit.empty() || unit == "-") return number;
  if (unit != "°") number += ' ';
  return number.append(prefix.symbol).append(unit);
}

std::string exact_number(double value, const SiPrefix& prefix) {
  std::array<char, 64> number;
  std::snprintf(number.data(), number.size(), "%.12g", value / prefix.factor);
  return number.data();
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
  return format_quantity(typed, unit, 6) + (high ? " is above the maximum " : " is below the minimum ") +
         format_quantity(high ? numbers.maximum : numbers.minimum, unit) +
         " and was set to it. Allowed: " + range_text_with_prefix(numbers) + ".";
}

std::string typed_unit(std::string_view unit, const SiPrefix& prefix) {
  return std::string(prefix.symbol == "µ" ? "u" : prefix.symbol).append(plain_spellings(unit).front());
}

UnitSpelling unit_at(std::string_view text, std::string_view unit) {
  UnitSpelling longest;
  const auto offer = [&](const std::string& spelling, double factor) {
    if (spelling.size() > longest.length && text.starts_with(spelling)) longest = {spelling.size(), factor};
  };
  offer(std::string(unit), 1);
  std::vector<std::string_view> ends = plain_spellings(unit);
  ends.insert(ends.end(), {std::string_view(), unit});
  for (const SiPrefix& prefix : kPrefixes) {
    if (!takes_prefix(unit)) break;
    for (const std::string_view end : ends) {
      offer(std::string(prefix.symbol).append(end), prefix.factor);
      if (prefix.factor == 1e-6) offer(std::string("u").append(end), prefix.factor);
    }
  }
  for (const OtherUnit& other : kOtherUnits)
    if (other.unit == unit) offer(std::string(other.spelling), other.factor);
  return longest;
}

}  // namespace griffith::ui
