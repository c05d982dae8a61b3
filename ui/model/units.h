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

/// The prefix that brings |value| into [1, 1000), from n to T. 0 and values below the table get none.
/// Units that take no prefix ("", "s", "-") and those in which a prefix is not customary ("kg/m³", "m/s") get none.
SiPrefix si_prefix(double value, std::string_view unit);

/// `value` with `digits` significant digits, prefix and unit: 15e9, "Pa" gives "15 GPa".
std::string format_quantity(double value, std::string_view unit, int digits = 4);

/// The same with a prefix that is given.
std::string format_quantity(double value, std::string_view unit, const SiPrefix& prefix, int digits = 4);

/// `number` with the prefix and the unit behind it: "15 GPa", "30°", "0.5".
std::string with_unit(std::string number, std::string_view unit, const SiPrefix& prefix);

/// `value` as a number of prefixed units with 12 digits, but no zeros at the end: to be edited and read back.
std::string exact_number(double value, const SiPrefix& prefix);

/// `value` as a number of prefixed units, without them: 15e6 with the prefix G gives "0.015".
std::string format_number(double value, const SiPrefix& prefix, int digits = 4);

/// The unit of a field as it stands behind a number: "°" for "degrees", nothing for a ratio.
std::string_view unit_symbol(const Numbers& numbers);

/// Both ends of what a field takes, with prefixes: "1 Pa to 10 TPa".
std::string range_text_with_prefix(const Numbers& numbers);

/// What to say of a typed value beyond that range: "5 is more than 1 and was set to it. From 0 to 1 is possible."
std::string clamped_note(double typed, const Numbers& numbers);

/// The components of a unit vector: "0.71, 0.00, -0.71".
std::string direction_text(const Vec3& direction);

/// A unit that a text begins with.
struct UnitSpelling {
  std::size_t length = 0;  ///< of its spelling [bytes]; 0: there is none
  double factor = 1;       ///< that it stands for
};

/// The longest spelling of `unit`, with a prefix or without, or of another unit of its kind, at the start of `text`:
/// "mm", "cm", "in" for "m"; "GPa", "G", "bar" for "Pa".
UnitSpelling unit_at(std::string_view text, std::string_view unit);

}  // namespace griffith::ui
