#include "sim/elasticity/element_frequency.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace griffith {
namespace {

/// Lowest frequency of slivers, in bar wave speeds over their edge length. That of well-shaped elements is below 10.
constexpr double kSliverFrequency = 20;
/// Largest fraction of a body's elements, its worst slivers, that may be relieved.
constexpr double kSliverFraction = 0.02;

double largest_eigenvalue(const Mat3& symmetric) {
  Eigen::SelfAdjointEigenSolver<Mat3> solver;
  return solver.computeDirect(symmetric, Eigen::EigenvaluesOnly).eigenvalues()[2];
}

/// Returns the highest frequency of a tet with a quarter of its mass at each corner [rad/s]. Along the axes of A = Σ
/// g_i g_iᵀ with eigenvalues a_i, shear has the eigenvalues mu (a_i + a_j), and extension those of lambda √(a_i a_j) +
/// 2 mu a_i δ_ij; all times 4/ρ.
double element_frequency(const ElasticLaw& law, double density, const RestElement& rest) {
  const Mat3 spread = rest.shape_gradients * rest.shape_gradients.transpose();
  Eigen::SelfAdjointEigenSolver<Mat3> solver;
  const Vec3 a = solver.computeDirect(spread, Eigen::EigenvaluesOnly).eigenvalues().cwiseMax(0);
  const Vec3 roots = a.cwiseSqrt();
  Mat3 stretch = law.lambda * roots * roots.transpose();
  stretch.diagonal() += 2 * law.mu * a;
  const double shear = law.mu * (a[1] + a[2]);
  return std::sqrt(4 / density * std::max(shear, largest_eigenvalue(stretch)));
}

/// True if an element is badly shaped, not merely small. `speed`: that of bar waves [m/s].
bool is_sliver(const RestElement& rest, double frequency, double speed) {
  return frequency * mean_element_size({&rest, 1}) > kSliverFrequency * speed;
}

double wave_speed_of(const ElasticLaw& law, double density) {
  return std::sqrt(law.mu * (3 * law.lambda + 2 * law.mu) / (law.lambda + law.mu) / density);
}

/// Returns the frequency above which there are as many slivers as may be relieved [rad/s].
double sliver_limit(std::vector<double> slivers, std::size_t elements) {
  const auto relieved = static_cast<std::size_t>(kSliverFraction * static_cast<double>(elements));
  if (slivers.size() <= relieved) return 0;
  std::ranges::nth_element(slivers, slivers.begin() + static_cast<std::ptrdiff_t>(relieved), std::ranges::greater());
  return slivers[relieved];
}

}  // namespace

std::vector<double> element_frequencies(const ElasticLaw& law, double density,
                                        std::span<const RestElement> rest_elements) {
  std::vector<double> frequencies;
  frequencies.reserve(rest_elements.size());
  for (const RestElement& rest : rest_elements) frequencies.push_back(element_frequency(law, density, rest));
  return frequencies;
}

double highest_frequency(const ElasticLaw& law, double density, std::span<const RestElement> rest_elements) {
  const std::vector<double> frequencies = element_frequencies(law, density, rest_elements);
  const double speed = wave_speed_of(law, density);
  double sound = 0;
  std::vector<double> slivers;
  for (std::size_t i = 0; i < rest_elements.size(); ++i) {
    if (is_sliver(rest_elements[i], frequencies[i], speed))
      slivers.push_back(frequencies[i]);
    else
      sound = std::max(sound, frequencies[i]);
  }
  return std::max(sound, sliver_limit(std::move(slivers), rest_elements.size()));
}

}  // namespace griffith
