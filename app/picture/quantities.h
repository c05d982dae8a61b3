#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "sim/core/linear_algebra.h"
#include "sim/world/frame.h"

namespace griffith::app {

/// What a scalar has one value of.
enum class ValuePlace { tet, node, face };

/// A scalar over a frame, for colours.
struct QuantityValues {
  ValuePlace place = ValuePlace::tet;
  std::vector<float> values;  ///< in the quantity's unit; of faces: four a tet, not a number where there is none
};

/// How near a tet was at rest to a regular one: 1 over its aspect ratio (mesh_quality.h), 0 flat to 1 regular.
double element_quality(const Frame& frame, std::size_t tet);

/// Whether the quantity `key` has values, and a unit; false for those that only tell things apart.
bool is_scalar(std::string_view key);

/// The values of the quantity `key`, one of view_quantities() with a unit; the others are no scalars.
QuantityValues quantity_values(const Frame& frame, std::string_view key);

/// How many of the finite values lie in each of `bins` equal parts of the range, those beyond it at its ends.
std::vector<int> histogram(const QuantityValues& values, const Vec2& range, int bins);

/// As far below 0 as above.
Vec2 symmetric_range(const Vec2& range);

/// Limits for colours that outliers do not spoil: from 0, or the 2nd percentile if values are negative, to the 98th.
/// Utilization and element quality always read from 0 to 1. Values that are not finite don't count. Never empty: the
/// least width is what is worth seeing of the quantity in these materials.
Vec2 automatic_range(const Frame& frame, std::string_view key, const QuantityValues& values);

}  // namespace griffith::app
