#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "sim/linear_algebra.h"

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

/// The components of a unit vector: "0.71, 0.00, -0.71".
std::string direction_text(const Vec3& direction);

/// Reads "20 GPa", "20G", "2e10 Pa" or "20" back into the unit without prefix. A bare number counts in
/// `bare_factor` units (the prefix on display). Nothing where the text isn't a number of that unit.
std::optional<double> parse_quantity(std::string_view text, std::string_view unit, double bare_factor = 1);

}  // namespace griffith::ui
