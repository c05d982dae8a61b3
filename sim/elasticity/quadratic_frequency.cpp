#include "sim/elasticity/quadratic_frequency.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "sim/core/tet_edge_corners.h"
#include "sim/elasticity/eigenvalues.h"

namespace griffith {
namespace {

/// Returns at least the largest eigenvalue of the map from stress to strain rate σ → sym(σ A), times the law [Pa/m²].
/// A = Σ g gᵀ, weighted. Exact for A along one axis and for equal ones.
double largest_of(const ElasticLaw& law, const Mat3& a) {
  const simd::Symmetric3<double> symmetric{a(0, 0), a(1, 1), a(2, 2), a(0, 1), a(0, 2), a(1, 2)};
  return std::max(law.lambda, 0.0) * a.trace() + 2 * law.mu * simd::largest_eigenvalue(symmetric);
}

Mat3 dyad(const Vec3& g) { return g * g.transpose(); }

template <std::size_t count>
std::vector<NodeStiffness> sums_of(std::span<const RestElement> rest_elements,
                                   std::span<const std::array<int, count>> indices,
                                   void (*add)(const RestElement&, int, NodeStiffness&)) {
  int most = -1;
  for (const std::array<int, count>& of_element : indices) most = std::max(most, std::ranges::max(of_element));
  std::vector<NodeStiffness> sums(most + 1);
  for (std::size_t e = 0; e < indices.size(); ++e)
    for (std::size_t i = 0; i < count; ++i) add(rest_elements[e], static_cast<int>(i), sums[indices[e][i]]);
  return sums;
}

template <std::size_t count>
std::array<double, count> ratios_of(const std::vector<NodeStiffness>& sums, const std::array<int, count>& indices) {
  std::array<double, count> ratios;
  for (std::size_t i = 0; i < count; ++i) ratios[i] = sums[indices[i]].ratio();
  return ratios;
}

}  // namespace

void add_corner_stiffness(const RestElement& rest, int corner, NodeStiffness& sums) {
  sums.stiffness += rest.volume * rest.shape_gradients.col(corner).squaredNorm();
  sums.volume += rest.volume / 4;
}

void add_edge_stiffness(const RestElement& rest, int edge, NodeStiffness& sums) {
  for (const int end : kTetEdges[edge]) sums.stiffness += rest.volume * rest.shape_gradients.col(end).squaredNorm();
  sums.volume += rest.volume;
}

/// The energy is V/20 (Σ_v ε_v:C:ε_v + 16 ε̄:C:ε̄) with the strains at the corners, ε_v = sym(Σ u_a g_aᵀ + 4 Σ_j w_vj
/// g_jᵀ), and their mean, ε̄ = sym(Σ u_a g_aᵀ + Σ w_ij (g_i + g_j)ᵀ). Each term is bounded by itself; in the first, an
/// edge's mass is divided between its ends by |g|² of the other end.
double bounding_frequency(const ElasticLaw& law, double density, const RestElement& rest,
                          const std::array<double, 4>& corners, const std::array<double, 6>& edges) {
  const Corners& g = rest.shape_gradients;
  Mat3 mean = Mat3::Zero();
  for (int a = 0; a < 4; ++a) mean += corners[a] / g.col(a).squaredNorm() * dyad(g.col(a));
  std::array<Mat3, 4> at;
  at.fill(mean);
  for (int edge = 0; edge < 6; ++edge) {
    const auto [i, j] = kTetEdges[edge];
    const double squares[2] = {g.col(i).squaredNorm(), g.col(j).squaredNorm()};
    mean += edges[edge] / (squares[0] + squares[1]) * dyad(g.col(i) + g.col(j));
    at[i] += 4 * edges[edge] / squares[1] * dyad(g.col(j));
    at[j] += 4 * edges[edge] / squares[0] * dyad(g.col(i));
  }
  double largest = 0;
  for (const Mat3& corner : at) largest = std::max(largest, largest_of(law, corner));
  return std::sqrt((0.8 * largest_of(law, mean) + 0.2 * largest) / density);
}

double highest_quadratic_frequency(const ElasticLaw& law, double density, std::span<const RestElement> rest_elements,
                                   std::span<const std::array<int, 4>> corners,
                                   std::span<const std::array<int, 6>> edges) {
  const std::vector<NodeStiffness> of_corners = sums_of(rest_elements, corners, add_corner_stiffness),
                                   of_edges = sums_of(rest_elements, edges, add_edge_stiffness);
  std::vector<double> frequencies;
  for (std::size_t e = 0; e < rest_elements.size(); ++e)
    frequencies.push_back(bounding_frequency(law, density, rest_elements[e], ratios_of(of_corners, corners[e]),
                                             ratios_of(of_edges, edges[e])));
  constexpr double kFew = 0.02;
  const auto few = static_cast<std::ptrdiff_t>(kFew * static_cast<double>(frequencies.size()));
  std::ranges::nth_element(frequencies, frequencies.begin() + few, std::ranges::greater());
  const double highest = *std::max_element(frequencies.begin(), frequencies.begin() + few + 1);
  return std::max(frequencies[few], highest / kFewOverMost);
}

}  // namespace griffith
