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

/// Reads "20 GPa", "20G", "2e10 Pa" or "2e10" back into the unit without prefix, which is that of a bare number.
/// Nothing where the text isn't a number of that unit.
std::optional<double> parse_quantity(std::string_view text, std::string_view unit);

}  // namespace griffith::ui
