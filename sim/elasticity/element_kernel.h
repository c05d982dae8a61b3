#pragma once

#include "sim/elasticity/compaction.h"
#include "sim/elasticity/eigenvalues.h"
#include "sim/elasticity/element.h"
#include "sim/elasticity/rotation_kernel.h"

// Kernels of element.h for one element (Real = double) or four side by side (DoubleLanes), with the same bits.

namespace griffith::simd {

/// ElementDeformation of each lane.
template <class Real>
struct Deformation {
  Matrix3<Real> frame;
  Symmetric3<Real> strain;
  decltype(Real{} > Real{}) inverted;

  ElementDeformation of(int lane) const { return {frame.of(lane), strain.of(lane), lane_of(inverted, lane)}; }
};

/// ElementState of each lane, and its stress as Cauchy stress in the world frame [Pa].
template <class Real>
struct State {
  Matrix3<Real> frame;
  Symmetric3<Real> stress;
  Matrix3<Real> tensile_traction;
  Symmetric3<Real> tension, cauchy_stress;
  Symmetric3<Real> compaction = {};
  Real tension_norm, energy_density;
  decltype(Real{} > Real{}) inverted;

  ElementState of(int lane) const {
    return {frame.of(lane),
            stress.of(lane),
            tensile_traction.of(lane),
            tension.of(lane),
            lane_of(tension_norm, lane),
            compaction.of(lane),
            lane_of(energy_density, lane),
            lane_of(inverted, lane)};
  }
};

/// Returns F = sum_i x_i g_iᵀ. place(i, corner) and slope(i, corner) are components of corners and of shape gradients.
template <class Real, class Place, class Slope>
Matrix3<Real> gradient_of(const Place& place, const Slope& slope) {
  Matrix3<Real> gradient = {};
  for (int corner = 0; corner < 4; ++corner) {
    const Real g[3] = {slope(0, corner), slope(1, corner), slope(2, corner)};
    for (int i = 0; i < 3; ++i) {
      const Real x = place(i, corner);
      for (int j = 0; j < 3; ++j) gradient.at[i][j] += x * g[j];
    }
  }
  return gradient;
}

/// `gradient`: F.
template <class Real>
Deformation<Real> deformation_of(ElementModel model, const Matrix3<Real>& gradient) {
  const Real zero = {};
  const Real ratio = determinant(gradient, cofactor(gradient));
  Deformation<Real> deformation;
  deformation.inverted = !(ratio > 0.0);
  if (model == ElementModel::corotational || any_of(deformation.inverted)) {
    deformation.frame = rotation_of(gradient);
    deformation.strain = add_to_diagonal(symmetric_product(deformation.frame, gradient), zero - 1.0);
  }
  if (model == ElementModel::green_strain) {
    const Symmetric3<Real> metric = symmetric_product(gradient, gradient);
    const Symmetric3<Real> green = (zero + 0.5) * add_to_diagonal(metric, zero - 1.0);
    deformation.frame = select(deformation.inverted, deformation.frame, gradient);
    deformation.strain = select(deformation.inverted, deformation.strain, green);
  }
  return deformation;
}

/// Returns B sigma Bᵀ / det B from B sigma. The volume ratio counts as at least 0.01, so that a flat element's stress
/// stays finite.
template <class Real>
Symmetric3<Real> pushed_forward(const Matrix3<Real>& traction, const Matrix3<Real>& frame, Real volume_ratio) {
  const Real zero = {};
  const Real bounded = volume_ratio < 0.01 ? zero + 0.01 : volume_ratio;
  return (1.0 / bounded) * times_transposed(traction, frame);
}

/// Adds what resists the compaction of each lane.
template <class Real>
void add_compaction(const ElasticLaw& law, const Deformation<Real>& deformation, State<Real>& state) {
  for (int lane = 0; lane < kLanesOf<Real>; ++lane) {
    const Compaction found = compaction_of(law, deformation.strain.of(lane), lane_of(deformation.inverted, lane));
    if (found.energy_density == 0) continue;
    state.stress.add(lane, found.stress);
    state.compaction.add(lane, found.gradient);
    set_lane(state.energy_density, lane, lane_of(state.energy_density, lane) + found.energy_density);
  }
}

template <class Real>
State<Real> state_of(const ElasticLaw& law, const Deformation<Real>& deformation,
                     const Symmetric3<Real>& stress_free_strain) {
  const Real zero = {};
  const Symmetric3<Real> strain = deformation.strain - stress_free_strain;
  State<Real> state;
  state.frame = deformation.frame;
  state.stress = add_to_diagonal((zero + 2 * law.mu) * strain, law.lambda * strain.trace());
  state.energy_density = 0.5 * contract(state.stress, strain);
  if (law.compaction > 0) add_compaction(law, deformation, state);
  state.tensile_traction = state.frame * tensile_part(state.stress);
  const Real volume_ratio = determinant(state.frame, cofactor(state.frame));
  state.tension = pushed_forward(state.tensile_traction, state.frame, volume_ratio);
  state.cauchy_stress = pushed_forward(state.frame * state.stress, state.frame, volume_ratio);
  state.tension_norm = root(state.tension.squared_norm());
  state.inverted = deformation.inverted;
  return state;
}

}  // namespace griffith::simd
