#include "app/picture/quantities.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <span>

#include "app/shared/quantile.h"
#include "sim/core/parallel.h"
#include "sim/elasticity/principal_stress.h"
#include "sim/meshing/mesh_quality.h"

namespace griffith::app {
namespace {

using Value = double (*)(const Frame& frame, std::size_t index);
/// Computes values from the index `first` on.
using Fill = void (*)(const Frame& frame, std::size_t first, std::span<float> values);

struct Quantity {
  std::string_view key;
  ValuePlace place;
  Value value;          ///< null if there is a `fill`
  Fill fill = nullptr;  ///< computes all at once
};

double crack_age(const Frame& frame, std::size_t face) {
  return frame.time - frame.elements.opened[face / 4][face % 4];
}

/// Returns the largest principal stresses, or with a sign of −1 the smallest, of four elements at once [Pa].
template <int sign>
void fill_extreme_stresses(const Frame& frame, std::size_t first, std::span<float> values) {
  constexpr std::size_t kLanes = 4;
  for (std::size_t i = 0; i < values.size(); i += kLanes) {
    const std::size_t count = std::min(kLanes, values.size() - i);
    std::array<Mat3, kLanes> stresses;
    for (std::size_t lane = 0; lane < kLanes; ++lane)  // extra lanes repeat the last element
      stresses[lane] = sign * frame.elements.stresses[first + i + std::min(lane, count - 1)];
    const std::array<double, kLanes> found = largest_principal_values(stresses);
    for (std::size_t lane = 0; lane < count; ++lane)
      values[i + lane] =
          stresses[lane].allFinite() ? static_cast<float>(sign * found[lane]) : std::numeric_limits<float>::quiet_NaN();
  }
}

constexpr std::array<Quantity, 13> kQuantities = {{
    {"utilization", ValuePlace::node,
     [](const Frame& frame, std::size_t i) { return frame.nodes.separations[i].utilization; }},
    {"von_mises", ValuePlace::tet,
     [](const Frame& frame, std::size_t i) { return von_mises_stress(frame.elements.stresses[i]); }},
    {"max_principal_stress", ValuePlace::tet, nullptr, fill_extreme_stresses<1>},
    {"mid_principal_stress", ValuePlace::tet,
     [](const Frame& frame, std::size_t i) { return principal_stresses(frame.elements.stresses[i])[1]; }},
    {"min_principal_stress", ValuePlace::tet, nullptr, fill_extreme_stresses<-1>},
    {"pressure", ValuePlace::tet,
     [](const Frame& frame, std::size_t i) { return -frame.elements.stresses[i].trace() / 3; }},
    {"separation_stress", ValuePlace::node,
     [](const Frame& frame, std::size_t i) { return frame.nodes.separations[i].stress; }},
    {"separation_eigenvalue", ValuePlace::node,
     [](const Frame& frame, std::size_t i) { return frame.nodes.separations[i].eigenvalue; }},
    {"strain_energy", ValuePlace::tet,
     [](const Frame& frame, std::size_t i) { return frame.elements.states[i].energy_density; }},
    {"displacement", ValuePlace::node,
     [](const Frame& frame, std::size_t i) {
       return (frame.nodes.positions[i] - frame.nodes.rest_positions[i]).norm();
     }},
    {"speed", ValuePlace::node, [](const Frame& frame, std::size_t i) { return frame.nodes.velocities[i].norm(); }},
    {"element_quality", ValuePlace::tet, element_quality},
    {"crack_age", ValuePlace::face, crack_age},
}};

std::size_t value_count(const Frame& frame, ValuePlace place) {
  if (place == ValuePlace::node) return frame.nodes.positions.size();
  return (place == ValuePlace::face ? 4 : 1) * frame.elements.tets.size();
}

/// Returns the width of a range below which differences are noise.
double min_width(const Frame& frame, std::string_view key) {
  constexpr double kStressFraction = 1e-4, kMinForce = 1e-3, kMinDisplacement = 1e-6, kMinSpeed = 1e-3,
                   kMinEnergy = 1e-3, kMinAge = 1e-3;
  if (key == "displacement") return kMinDisplacement;
  if (key == "speed") return kMinSpeed;
  if (key == "separation_eigenvalue") return kMinForce;
  if (key == "strain_energy") return kMinEnergy;
  if (key == "crack_age") return kMinAge;
  double strength = 1;
  for (const Material& material : frame.materials) strength = std::max(strength, material.tensile_strength);
  return kStressFraction * strength;
}

}  // namespace

double element_quality(const Frame& frame, std::size_t tet) {
  std::array<Vec3, 4> corners;
  for (std::size_t i = 0; i < 4; ++i) corners[i] = frame.nodes.rest_positions[frame.elements.tets[tet][i]];
  return 1 / aspect_ratio(corners);
}

bool is_scalar(std::string_view key) {
  return std::ranges::find(kQuantities, key, &Quantity::key) != kQuantities.end();
}

QuantityValues quantity_values(const Frame& frame, std::string_view key) {
  const auto found = std::ranges::find(kQuantities, key, &Quantity::key);
  assert(found != kQuantities.end());
  QuantityValues result;
  result.place = found->place;
  result.values.resize(value_count(frame, found->place));
  parallel_for(static_cast<int>(result.values.size()), 4096, [&](int begin, int end) {
    const auto first = static_cast<std::size_t>(begin), count = static_cast<std::size_t>(end - begin);
    if (found->fill) return found->fill(frame, first, std::span(result.values).subspan(first, count));
    for (std::size_t i = first; i < first + count; ++i) result.values[i] = static_cast<float>(found->value(frame, i));
  });
  return result;
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
  if (key == "utilization" || key == "element_quality") return {0, 1};
  std::vector<float> numbers = finite(values.values);
  Vec2 range(std::min(0.0f, quantile_of(numbers, 0.02)), std::max(0.0f, quantile_of(numbers, 0.98)));
  const double missing = min_width(frame, key) - (range[1] - range[0]);
  if (missing > 0)
    (range[1] > 0 || range[0] == 0 ? range[1] : range[0]) += range[1] > 0 || range[0] == 0 ? missing : -missing;
  return range;
}

}  // namespace griffith::app
