#pragma once

#include <variant>
#include <vector>

#include "sim/core/linear_algebra.h"
#include "sim/fracture/node_separation.h"
#include "sim/scene/quantities.h"
#include "sim/world/output/frame.h"

namespace griffith {

/// Location of a quantity's values.
enum class ValuePlace { tet, node, face, corner };

/// Returns the location of a quantity that has values.
ValuePlace place_of(const Quantity& quantity);

/// A scalar field of a frame, for colors.
struct QuantityValues {
  ValuePlace place = ValuePlace::tet;
  std::vector<float> values;  ///< in the quantity's unit; of faces and corners four per tet, NaN where there is none
};

/// Returns the values of a quantity as scalars: of a vector or tensor the norm.
QuantityValues quantity_values(const Frame& frame, const Quantity& quantity);

/// Returns the same with the values of stresses at the corners of tets, if some are quadratic: stress is linear in
/// them, and may differ between neighbors.
QuantityValues linear_values(const Frame& frame, const Quantity& quantity);

using QuantityArray = std::variant<std::vector<double>, std::vector<Vec3>, std::vector<Mat3>>;

/// Returns the values of a quantity of nodes or elements in double precision. Those of nodes are followed by the values
/// in the middle of the edges of quadratic tets, where separation is the mean of that of the ends.
QuantityArray quantity_array(const Frame& frame, const Quantity& quantity);

/// Returns the sum of no separations, to which add_separation() adds.
NodeSeparation zero_separation();
/// Adds `weight` times a node's separation to a weighted mean.
void add_separation(double weight, const NodeSeparation& separation, NodeSeparation& mean);

}  // namespace griffith
