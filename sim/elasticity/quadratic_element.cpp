#include "sim/elasticity/quadratic_element.h"

#include <Eigen/LU>
#include <cmath>

#include "sim/core/tet_edge_corners.h"
#include "sim/elasticity/element_kernel.h"

namespace griffith {
namespace {

using simd::DoubleLanes;

/// Returns ε_kij m_ij, up to the sign twice the axial vector of the skew part.
Vec3 axial(const Mat3& m) { return {m(1, 2) - m(2, 1), m(2, 0) - m(0, 2), m(0, 1) - m(1, 0)}; }

/// Returns the matrix Z with z·axial(m) = Z : m for all m.
Mat3 skew(const Vec3& z) {
  Mat3 m;
  m << 0, z[2], -z[1], -z[2], 0, z[0], z[1], -z[0], 0;
  return m;
}

/// Returns V/20 (σ_v + Σ σ), the weighted stress of each corner [J].
std::array<Mat3, 4> weighted_stresses(const RestElement& rest, const std::array<ElementState, 4>& corners) {
  Mat3 sum = Mat3::Zero();
  for (const ElementState& corner : corners) sum += corner.stress.full();
  std::array<Mat3, 4> weighted;
  for (int v = 0; v < 4; ++v) weighted[v] = rest.volume / 20 * (corners[v].stress.full() + sum);
  return weighted;
}

/// Returns the deformations of the corners side by side. All use the frame of F_0, except with Green's strain.
simd::Deformation<DoubleLanes> corner_deformations(ElementModel model, const simd::Deformation<double>& whole,
                                                   const std::array<Mat3, 4>& gradients) {
  const simd::Matrix3<DoubleLanes> f = simd::side_by_side(gradients);
  const DoubleLanes zero = {};
  simd::Deformation<DoubleLanes> corners;
  corners.inverted = whole.inverted ? zero == zero : zero != zero;
  if (model == ElementModel::green_strain && !whole.inverted) {
    corners.frame = f;
    corners.strain = (zero + 0.5) * simd::add_to_diagonal(simd::symmetric_product(f, f), zero - 1.0);
  } else {
    const Mat3 q = whole.frame.of(0);
    corners.frame = simd::side_by_side({q, q, q, q});
    corners.strain = simd::add_to_diagonal(simd::symmetric_product(corners.frame, f), zero - 1.0);
  }
  return corners;
}

/// Returns the mean of the four lanes.
simd::Symmetric3<double> mean_of(const simd::Symmetric3<DoubleLanes>& s) {
  const auto mean = [](const DoubleLanes& x) { return 0.25 * ((x[0] + x[1]) + (x[2] + x[3])); };
  return {mean(s.xx), mean(s.yy), mean(s.zz), mean(s.xy), mean(s.xz), mean(s.yz)};
}

simd::Symmetric3<DoubleLanes> in_all_lanes(const simd::Symmetric3<double>& s) {
  const DoubleLanes zero = {};
  return {zero + s.xx, zero + s.yy, zero + s.zz, zero + s.xy, zero + s.xz, zero + s.yz};
}

/// Returns the traction on corners that follows from the dependence of the rotation Q on F_0 = Q S. With δQ = Q Ω, the
/// energy changes by Q Z : δF_0, Z the skew matrix of (tr(S) I − S)⁻¹ axial(Σ Qᵀ F_v s_v). Zero if the element is flat,
/// where Q jumps.
Mat3 turning_traction(const Mat3& q, const Mat3& whole, const std::array<Mat3, 4>& gradients,
                      const std::array<Mat3, 4>& weighted) {
  Mat3 moments = Mat3::Zero();
  for (int v = 0; v < 4; ++v) moments += q.transpose() * gradients[v] * weighted[v];
  const Mat3 stretch = q.transpose() * whole;
  const Mat3 turning = stretch.trace() * Mat3::Identity() - stretch;
  const Vec3 z = turning.inverse() * axial(moments);
  return z.allFinite() ? Mat3(q * skew(z)) : Mat3(Mat3::Zero());
}

}  // namespace

std::array<Mat3, 4> corner_gradients(const RestElement& rest, const Corners& corners, const EdgeVectors& offsets) {
  const Mat3 whole = deformation_gradient(rest, corners);
  std::array<Mat3, 4> gradients = {whole, whole, whole, whole};
  for (int edge = 0; edge < 6; ++edge) {
    const auto [p, q] = kTetEdges[edge];
    gradients[p] += 4 * offsets.col(edge) * rest.shape_gradients.col(q).transpose();
    gradients[q] += 4 * offsets.col(edge) * rest.shape_gradients.col(p).transpose();
  }
  return gradients;
}

QuadraticStates quadratic_states(const ElasticLaw& law, const RestElement& rest, const Corners& corners,
                                 const EdgeVectors& offsets, const Mat3& plastic_strain) {
  const Mat3 gradient = deformation_gradient(rest, corners);
  const std::array<Mat3, 4> gradients = corner_gradients(rest, corners, offsets);
  simd::Deformation<double> whole = simd::deformation_of(law.model, simd::numbers(gradient));
  const simd::Deformation<DoubleLanes> deformations = corner_deformations(law.model, whole, gradients);
  const simd::Symmetric3<double> stress_free = simd::upper_triangle(plastic_strain);
  const simd::State<DoubleLanes> found = simd::state_of(law, deformations, in_all_lanes(stress_free));
  whole.strain = mean_of(deformations.strain);
  const simd::State<double> mean = simd::state_of(law, whole, stress_free);

  QuadraticStates states{{}, mean.of(0), mean.cauchy_stress.of(0)};
  double energy_densities = 0;
  for (int v = 0; v < 4; ++v) {
    states.state.corners[v] = found.of(v);
    energy_densities += states.state.corners[v].energy_density;
  }
  states.mean.energy_density = 0.8 * states.mean.energy_density + 0.05 * energy_densities;

  const std::array<Mat3, 4> weighted = weighted_stresses(rest, states.state.corners);
  Mat3& traction = states.state.corner_traction;
  for (int v = 0; v < 4; ++v) traction += states.state.corners[v].frame * weighted[v];
  if (law.model == ElementModel::corotational || whole.inverted)
    traction += turning_traction(states.mean.frame, gradient, gradients, weighted);
  return states;
}

QuadraticForces quadratic_forces(const RestElement& rest, const QuadraticState& state) {
  const std::array<Mat3, 4> weighted = weighted_stresses(rest, state.corners);
  QuadraticForces forces{-state.corner_traction * rest.shape_gradients, {}};
  for (int edge = 0; edge < 6; ++edge) {
    const auto [p, q] = kTetEdges[edge];
    forces.edges.col(edge) = -4 * (state.corners[p].frame * (weighted[p] * rest.shape_gradients.col(q)) +
                                   state.corners[q].frame * (weighted[q] * rest.shape_gradients.col(p)));
  }
  return forces;
}

QuadraticForces quadratic_damping_forces(const ElasticLaw& law, const RestElement& rest, const Mat3& frame,
                                         const Corners& velocities, const EdgeVectors& of_edges) {
  const std::array<Mat3, 4> rates = corner_gradients(rest, velocities, of_edges);
  QuadraticState state;
  for (int v = 0; v < 4; ++v) {
    const Mat3 rate = frame.transpose() * rates[v], strain = 0.5 * (rate + rate.transpose());
    const double pressure = law.lambda * strain.trace();
    state.corners[v].frame = frame;
    state.corners[v].stress = {2 * law.mu * strain(0, 0) + pressure,
                               2 * law.mu * strain(1, 1) + pressure,
                               2 * law.mu * strain(2, 2) + pressure,
                               2 * law.mu * strain(0, 1),
                               2 * law.mu * strain(0, 2),
                               2 * law.mu * strain(1, 2)};
  }
  for (const Mat3& weighted : weighted_stresses(rest, state.corners)) state.corner_traction += frame * weighted;
  return quadratic_forces(rest, state);
}

}  // namespace griffith
