#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "sim/core/linear_algebra.h"
#include "sim/scene/field.h"

namespace griffith::ui {

/// A factor of ten with its sign, such as 1e6 and "M".
struct SiPrefix {
  double factor = 1;
  std::string_view symbol;
};

/// Returns the prefix that brings |value| into [1, 1000), from n to T; none for 0, values below the table, and units
/// that take no prefix ("", "s", "-", "kg/m³", "m/s").
SiPrefix si_prefix(double value, std::string_view unit);

/// Formats `value` with `digits` significant digits, prefix and unit: 15e9, "Pa" gives "15 GPa".
std::string format_quantity(double value, std::string_view unit, int digits = 4);

/// Formats `value` with a given prefix.
std::string format_quantity(double value, std::string_view unit, const SiPrefix& prefix, int digits = 4);

/// Appends prefix and unit to `number`: "15 GPa", "30°", "0.5".
std::string with_unit(std::string number, std::string_view unit, const SiPrefix& prefix);

/// Formats `value` in prefixed units with 12 digits and no trailing zeros, to be edited and read back.
std::string exact_number(double value, const SiPrefix& prefix);

/// Formats `value` in prefixed units without naming them: 15e6 with the prefix G gives "0.015".
std::string format_number(double value, const SiPrefix& prefix, int digits = 4);

/// Returns the unit of a field as written after a number: "°" for "degrees", empty for a ratio.
std::string_view unit_symbol(const Numbers& numbers);

/// Returns the limits of a field with prefixes: "1 Pa to 10 TPa".
std::string range_text_with_prefix(const Numbers& numbers);

/// Explains that a typed value was clamped: "5 is above the maximum 1 and was set to it. Allowed: 0 to 1."
std::string clamped_note(double typed, const Numbers& numbers);

/// Formats the components of a unit vector: "0.71, 0.00, -0.71".
std::string direction_text(const Vec3& direction);

/// Returns a prefixed unit as any keyboard types it: "MPa sqrt(m)", "um".
std::string typed_unit(std::string_view unit, const SiPrefix& prefix);

/// A unit at the start of a text.
struct UnitSpelling {
  std::size_t length = 0;  ///< bytes of its spelling; 0: none
  double factor = 1;       ///< factor to the base unit
};

/// Returns the longest spelling of `unit`, with or without a prefix, or of another unit of its kind, at the start of
/// `text`: "mm", "cm", "in" for "m"; "GPa", "G", "bar" for "Pa".
UnitSpelling unit_at(std::string_view text, std::string_view unit);

}  // namespace griffith::ui
