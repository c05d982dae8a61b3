#pragma once

#include <string_view>
#include <vector>

#include "sim/core/linear_algebra.h"
#include "sim/world/output/frame.h"
#include "sim/world/output/quantity_values.h"

namespace griffith::app {

/// True if the quantity `key` has numeric values; false if it only distinguishes objects.
bool is_scalar(std::string_view key);

/// True if values of the quantity follow from strain, which bodies that move as a whole do not have.
bool follows_from_strain(std::string_view key);

/// Returns the values of a quantity with NaN in place of those of rigid bodies, which have no strain, if it follows
/// from strain.
QuantityValues strained_values(const Frame& frame, std::string_view key, QuantityValues values);

/// Returns counts of the finite values in `bins` equal parts of the range; values beyond it count at its ends.
std::vector<int> histogram(const QuantityValues& values, const Vec2& range, int bins);

/// Extends a range to one symmetric about 0.
Vec2 symmetric_range(const Vec2& range);

/// Returns the range of colors of a quantity (Quantity::range), or one that ignores outliers: from 0, or the 2nd
/// percentile if values are negative, to the 98th. Counts strained_values(), and of these finite ones. Never empty: the
/// least width is the smallest relevant difference (Quantity::noise).
Vec2 automatic_range(const Frame& frame, std::string_view key, const QuantityValues& values);

}  // namespace griffith::app
