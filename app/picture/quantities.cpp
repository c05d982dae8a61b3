#include "app/picture/quantities.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "app/shared/quantile.h"
#include "sim/scene/quantities.h"

namespace griffith::app {
namespace {

/// Returns the width of a range below which differences are noise.
double min_width(const Frame& frame, const Quantity& quantity) {
  constexpr double kStressFraction = 1e-4;
  if (quantity.noise > 0) return quantity.noise;
  double strength = 1;
  for (const Material& material : frame.materials) strength = std::max(strength, material.tensile_strength);
  return kStressFraction * strength;
}

}  // namespace

bool is_scalar(std::string_view key) {
  const Quantity* quantity = find_view_quantity(key);
  return quantity && quantity->has_values();
}

bool follows_from_strain(std::string_view key) {
  const Quantity* quantity = find_view_quantity(key);
  if (!quantity) return false;
  if (place_of(*quantity) == ValuePlace::tet)
    return !std::holds_alternative<double (*)(const ShapeSample&)>(quantity->function);
  const auto* of_node = std::get_if<double (*)(const NodeSample&)>(&quantity->function);
  if (!of_node) return false;
  const NodeSeparation none = zero_separation();
  NodeSeparation some = none;
  some.eigenvalue = some.stress = some.utilization = 1;
  const auto value = [&](const NodeSeparation& separation) {
    return (*of_node)({Vec3::Zero(), Vec3::Zero(), Vec3::Zero(), separation});
  };
  return value(some) != value(none);
}

QuantityValues strained_values(const Frame& frame, std::string_view key, QuantityValues values) {
  if (!follows_from_strain(key)) return values;
  const std::size_t per_tet = values.place == ValuePlace::tet ? 1 : 4;
  for (std::size_t tet = 0; tet < frame.elements.bodies.size(); ++tet) {
    if (!frame.bodies[frame.elements.bodies[tet]].rigid) continue;
    for (std::size_t i = 0; i < per_tet; ++i) {
      const std::size_t place = values.place == ValuePlace::node
                                    ? static_cast<std::size_t>(frame.elements.tets[tet][i].index())
                                    : per_tet * tet + i;
      values.values[place] = std::numeric_limits<float>::quiet_NaN();
    }
  }
  return values;
}

std::vector<int> histogram(const QuantityValues& values, const Vec2& range, int bins) {
  std::vector<int> counts(static_cast<std::size_t>(bins), 0);
  for (const float value : values.values) {
    if (!std::isfinite(value)) continue;
    const double t = std::clamp((value - range[0]) / (range[1] - range[0]), 0.0, 1.0);
    ++counts[std::min(static_cast<std::size_t>(t * bins), counts.size() - 1)];
  }
  return counts;
}

Vec2 symmetric_range(const Vec2& range) {
  const double reach = range.cwiseAbs().maxCoeff();
  return {-reach, reach};
}

Vec2 automatic_range(const Frame& frame, std::string_view key, const QuantityValues& values) {
  const Quantity& quantity = *find_view_quantity(key);
  if (quantity.range) return {(*quantity.range)[0], (*quantity.range)[1]};
  std::vector<float> numbers = finite(strained_values(frame, key, values).values);
  Vec2 range(std::min(0.0f, quantile_of(numbers, 0.02)), std::max(0.0f, quantile_of(numbers, 0.98)));
  const double missing = min_width(frame, quantity) - (range[1] - range[0]);
  if (missing > 0)
    (range[1] > 0 || range[0] == 0 ? range[1] : range[0]) += range[1] > 0 || range[0] == 0 ? missing : -missing;
  return range;
}

}  // namespace griffith::app
