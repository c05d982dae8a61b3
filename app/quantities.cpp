#include "app/quantities.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

namespace griffith::app {
namespace {

using TetValue = double (*)(const Mat3& stress);
using NodeValue = double (*)(const Frame& frame, std::size_t node);

struct TetQuantity {
  std::string_view key;
  TetValue value;
};
struct NodeQuantity {
  std::string_view key;
  NodeValue value;
};

constexpr std::array<TetQuantity, 4> kTetQuantities = {{
    {"von_mises", von_mises_stress},
    {"max_principal_stress", [](const Mat3& stress) { return principal_stresses(stress)[0]; }},
    {"min_principal_stress", [](const Mat3& stress) { return principal_stresses(stress)[2]; }},
    {"pressure", [](const Mat3& stress) { return -stress.trace() / 3; }},
}};

constexpr std::array<NodeQuantity, 4> kNodeQuantities = {{
    {"margin", [](const Frame& frame, std::size_t node) { return frame.separations[node].margin; }},
    {"separation_eigenvalue", [](const Frame& frame, std::size_t node) { return frame.separations[node].eigenvalue; }},
    {"displacement",
     [](const Frame& frame, std::size_t node) { return (frame.positions[node] - frame.rest_positions[node]).norm(); }},
    {"speed", [](const Frame& frame, std::size_t node) { return frame.velocities[node].norm(); }},
}};

/// What lies at `share` (0..1) of the sorted values.
double percentile(std::vector<float>& values, double share) {
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

/// Differences below it are noise.
double least_width(const Frame& frame, std::string_view key) {
  constexpr double kStressShare = 1e-4, kLeastForce = 1e-3, kLeastDisplacement = 1e-6, kLeastSpeed = 1e-3;
  if (key == "displacement") return kLeastDisplacement;
  if (key == "speed") return kLeastSpeed;
  if (key == "separation_eigenvalue") return kLeastForce;
  double strength = 1;
  for (const Material& material : frame.materials) strength = std::max(strength, material.tensile_strength);
  return kStressShare * strength;
}

}  // namespace

double von_mises_stress(const Mat3& stress) {
  const Mat3 deviator = stress - stress.trace() / 3 * Mat3::Identity();
  return std::sqrt(1.5) * deviator.norm();
}

Vec3 principal_stresses(const Mat3& stress) {
  if (!stress.allFinite()) return Vec3::Constant(std::numeric_limits<double>::quiet_NaN());
  return Eigen::SelfAdjointEigenSolver<Mat3>(stress, Eigen::EigenvaluesOnly).eigenvalues().reverse();
}

QuantityValues quantity_values(const Frame& frame, std::string_view key) {
  QuantityValues result;
  for (const TetQuantity& quantity : kTetQuantities) {
    if (quantity.key != key) continue;
    for (const Mat3& stress : frame.stresses) result.values.push_back(static_cast<float>(quantity.value(stress)));
    return result;
  }
  const auto found = std::find_if(kNodeQuantities.begin(), kNodeQuantities.end(),
                                  [key](const NodeQuantity& quantity) { return quantity.key == key; });
  assert(found != kNodeQuantities.end());
  result.per_node = true;
  for (std::size_t node = 0; node < frame.positions.size(); ++node) {
    result.values.push_back(static_cast<float>(found->value(frame, node)));
  }
  return result;
}

Vec2 automatic_range(const Frame& frame, std::string_view key, const QuantityValues& values) {
  if (key == "margin") return {0, 1};
  std::vector<float> finite;
  std::copy_if(values.values.begin(), values.values.end(), std::back_inserter(finite),
               [](float value) { return std::isfinite(value); });
  Vec2 range = Vec2::Zero();
  if (!finite.empty()) range = {std::min(0.0, percentile(finite, 0.02)), std::max(0.0, percentile(finite, 0.98))};
  const double missing = least_width(frame, key) - (range[1] - range[0]);
  if (missing > 0)
    (range[1] > 0 || range[0] == 0 ? range[1] : range[0]) += range[1] > 0 || range[0] == 0 ? missing : -missing;
  return range;
}

}  // namespace griffith::app
