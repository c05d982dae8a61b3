#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "sim/core/linear_algebra.h"
#include "sim/world/frame.h"

namespace griffith::app {

/// Location of a scalar's values.
enum class ValuePlace { tet, node, face };

/// A scalar field of a frame, for colors.
struct QuantityValues {
  ValuePlace place = ValuePlace::tet;
  std::vector<float> values;  ///< in the quantity's unit; for faces four per tet, NaN where there is none
};

/// Returns the reciprocal of a tet's aspect ratio at rest (mesh_quality.h): 0 flat to 1 regular.
double element_quality(const Frame& frame, std::size_t tet);

/// True if the quantity `key` has numeric values; false if it only distinguishes objects.
bool is_scalar(std::string_view key);

/// Returns the values of the scalar quantity `key`, one of view_quantities().
QuantityValues quantity_values(const Frame& frame, std::string_view key);

/// Returns counts of the finite values in `bins` equal parts of the range; values beyond it count at its ends.
std::vector<int> histogram(const QuantityValues& values, const Vec2& range, int bins);

/// Extends a range to one symmetric about 0.
Vec2 symmetric_range(const Vec2& range);

/// Returns a color range that ignores outliers: from 0, or the 2nd percentile if values are negative, to the 98th.
/// Utilization and element quality always range from 0 to 1. Values that are not finite are ignored. Never empty: the
/// least width is the smallest relevant difference in these materials.
Vec2 automatic_range(const Frame& frame, std::string_view key, const QuantityValues& values);

}  // namespace griffith::app
