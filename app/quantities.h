#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "sim/linear_algebra.h"
#include "sim/world/frame.h"

namespace griffith::app {

/// A scalar over a frame, for colours.
struct QuantityValues {
  bool per_node = false;      ///< one value a node, else one a tet
  std::vector<float> values;  ///< in the quantity's unit
};

/// The von Mises stress √(3/2 s:s), s the deviator of `stress` [Pa].
double von_mises_stress(const Mat3& stress);
/// The eigenvalues of a symmetric stress, largest first [Pa].
Vec3 principal_stresses(const Mat3& stress);

/// The values of the quantity `key`, one of view_quantities() with a unit; the others are no scalars.
QuantityValues quantity_values(const Frame& frame, std::string_view key);

/// Limits for colours that outliers do not spoil: from 0, or the 2nd percentile if values are negative, to the 98th.
/// The margin always reads from 0 to 1. Values that are not finite don't count. Never empty: the least width is what is
/// worth seeing of the quantity in these materials.
Vec2 automatic_range(const Frame& frame, std::string_view key, const QuantityValues& values);

}  // namespace griffith::app
