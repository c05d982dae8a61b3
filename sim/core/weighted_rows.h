#pragma once

#include <array>

#include "sim/core/linear_algebra.h"

namespace griffith {

/// Point whose velocity is the sum of weights_i · v(rows_i) over a few nodes.
struct WeightedRows {
  std::array<int, 3> rows;  ///< -1 for a fixed node
  std::array<Mat3, 3> weights;
  bool operator==(const WeightedRows&) const = default;
};

}  // namespace griffith
