#include "sim/elasticity/quadratic_element.h"

#include <Eigen/LU>
#include <cmath>

#include "sim/core/tet_edge_corners.h"
#include "sim/elasticity/element_kernel.h"
#include "sim/elasticity/quadratic_batch.h"

namespace griffith {
namespace {

using simd::DoubleLanes;

/// Returns V/20 (σ_v + Σ σ), the weighted stress of each corner [J].
CornerTensors weighted_stresses(const RestElement& rest, const std::array<ElementState, 4>& corners) {
  Mat3 sum = Mat3::Zero();
  for (const ElementState& corner : corners) sum += corner.stress.full();
  CornerTensors weighted;
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

template <class Real>
void set_lane(simd::Symmetric3<Real>& s, int lane, const simd::Symmetric3<double>& value) {
  simd::set_lane(s.xx, lane, value.xx), simd::set_lane(s.yy, lane, value.yy), simd::set_lane(s.zz, lane, value.zz);
  simd::set_lane(s.xy, lane, value.xy), simd::set_lane(s.xz, lane, value.xz), simd::set_lane(s.yz, lane, value.yz);
}

/// Returns the mean of the four lanes.
simd::Symmetric3<double> mean_of(const simd::Symmetric3<DoubleLanes>& s) {
  const auto mean = [](const DoubleLanes& x) { return 0.25 * ((x[0] + x[1]) + (x[2] + x[3])); };
  return {mean(s.xx), mean(s.yy), mean(s.zz), mean(s.xy), mean(s.xz), mean(s.yz)};
}

simd::Symmetric3<DoubleLanes> symmetric_lanes(const CornerTensors& m) {
  const auto entry = [&](int i, int j) { return DoubleLanes{m[0](i, j), m[1](i, j), m[2](i, j), m[3](i, j)}; };
  return {entry(0, 0), entry(1, 1), entry(2, 2), entry(0, 1), entry(0, 2), entry(1, 2)};
}

/// Returns the forces on the edges of the weighted stresses s_v in the frames B_v.
EdgeVectors edge_forces(const RestElement& rest, const CornerTensors& frames, const CornerTensors& weighted) {
  EdgeVectors forces;
  for (int edge = 0; edge < 6; ++edge) {
    const auto [p, q] = kTetEdges[edge];
    forces.col(edge) = -4 * (frames[p] * (weighted[p] * rest.shape_gradients.col(q)) +
                             frames[q] * (weighted[q] * rest.shape_gradients.col(p)));
  }
  return forces;
}

/// Sets the forces of stresses at corners, without those of a rotating frame.
void set_forces(const RestElement& rest, const CornerTensors& weighted, QuadraticState& state) {
  CornerTensors frames;
  for (int v = 0; v < 4; ++v) {
    frames[v] = state.corners[v].frame;
    state.corner_traction += frames[v] * weighted[v];
  }
  state.edge_forces = edge_forces(rest, frames, weighted);
}

/// Returns the stress-free strains of material at the corners that flows.
CornerTensors flowed_at_corners(const PlasticLaw& law, const simd::Deformation<DoubleLanes>& deformations,
                                const CornerTensors& stress_free) {
  CornerTensors flowed;
  for (int v = 0; v < 4; ++v) flowed[v] = flow(law, deformations.of(v), stress_free[v]);
  return flowed;
}

/// Replaces the states of the corners by those of material that has flowed there.
void read_flowed(const ElasticLaw& law, const PlasticLaw& plastic, const simd::Deformation<DoubleLanes>& deformations,
                 const CornerTensors& stress_free, QuadraticState& state) {
  const CornerTensors flowed = flowed_at_corners(plastic, deformations, stress_free);
  const simd::State<DoubleLanes> read = simd::state_of(law, deformations, symmetric_lanes(flowed));
  for (int v = 0; v < 4; ++v) state.corners[v] = read.of(v);
}

/// Returns Σ Qᵀ F_v s_v.
Mat3 moments_of(const Mat3& q, const std::array<Mat3, 4>& gradients, const std::array<Mat3, 4>& weighted) {
  Mat3 moments = Mat3::Zero();
  for (int v = 0; v < 4; ++v) moments += q.transpose() * gradients[v] * weighted[v];
  return moments;
}

}  // namespace

CornerTensors at_integration_points(const CornerTensors& corners) {
  const double far = (5 - std::sqrt(5.0)) / 20, own = 1 / std::sqrt(5.0);
  const Mat3 shared = far * (corners[0] + corners[1] + corners[2] + corners[3]);
  CornerTensors points;
  for (int v = 0; v < 4; ++v) points[v] = own * corners[v] + shared;
  return points;
}

CornerTensors at_corners(const CornerTensors& points) {
  const double far = (5 - std::sqrt(5.0)) / 20, own = 1 / std::sqrt(5.0);
  const Mat3 shared = far * (points[0] + points[1] + points[2] + points[3]);
  CornerTensors corners;
  for (int v = 0; v < 4; ++v) corners[v] = (points[v] - shared) / own;
  return corners;
}

CornerStrains corner_strains(ElementModel model, const RestElement& rest, const Corners& corners,
                             const EdgeVectors& offsets) {
  const simd::Deformation<double> whole =
      simd::deformation_of(model, simd::numbers(deformation_gradient(rest, corners)));
  const simd::Deformation<DoubleLanes> deformations =
      corner_deformations(model, whole, corner_gradients(rest, corners, offsets));
  CornerStrains strains{{}, whole.inverted};
  for (int v = 0; v < 4; ++v) strains.corners[v] = deformations.strain.of(v);
  return strains;
}

CornerTensors flow(const PlasticLaw& law, const CornerStrains& strains, const CornerTensors& plastic_strains) {
  const CornerTensors at_points = at_integration_points(strains.corners);
  CornerTensors flowed;
  for (int i = 0; i < 4; ++i)
    flowed[i] = flow(law, ElementDeformation{Mat3::Identity(), at_points[i], strains.inverted}, plastic_strains[i]);
  return flowed;
}

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
                                 const EdgeVectors& offsets, const CornerTensors& stress_free,
                                 const std::optional<PlasticLaw>& plastic) {
  const Mat3 gradient = deformation_gradient(rest, corners);
  const std::array<Mat3, 4> gradients = corner_gradients(rest, corners, offsets);
  simd::Deformation<double> whole = simd::deformation_of(law.model, simd::numbers(gradient));
  const simd::Deformation<DoubleLanes> deformations = corner_deformations(law.model, whole, gradients);
  const simd::Symmetric3<DoubleLanes> free = symmetric_lanes(stress_free);
  const simd::State<DoubleLanes> found = simd::state_of(law, deformations, free);
  whole.strain = mean_of(deformations.strain);
  const simd::State<double> mean = simd::state_of(law, whole, mean_of(free));

  QuadraticStates states{{}, mean.of(0), mean.cauchy_stress.of(0)};
  double energy_densities = 0;
  for (int v = 0; v < 4; ++v) {
    states.state.corners[v] = found.of(v);
    energy_densities += states.state.corners[v].energy_density;
  }
  states.mean.energy_density = 0.8 * states.mean.energy_density + 0.05 * energy_densities;

  const CornerTensors weighted = weighted_stresses(rest, states.state.corners);
  set_forces(rest, weighted, states.state);
  if (law.model == ElementModel::corotational || whole.inverted)
    states.state.corner_traction +=
        turning_traction(states.mean.frame, gradient, moments_of(states.mean.frame, gradients, weighted));
  if (plastic) read_flowed(law, *plastic, deformations, stress_free, states.state);
  return states;
}

std::array<QuadraticStates, 4> quadratic_stresses(const ElasticLaw& law, const std::array<PlacedQuadratic, 4>& elements,
                                                  const std::optional<PlasticLaw>& plastic) {
  std::array<Mat3, 4> gradients;
  for (int i = 0; i < 4; ++i) gradients[i] = deformation_gradient(*elements[i].rest, elements[i].corners);
  simd::Deformation<DoubleLanes> wholes = simd::deformation_of(law.model, simd::side_by_side(gradients));
  std::array<QuadraticStates, 4> states;
  simd::Symmetric3<DoubleLanes> mean_free;
  for (int i = 0; i < 4; ++i) {
    const PlacedQuadratic& placed = elements[i];
    const simd::Deformation<double> whole{simd::numbers(wholes.frame.of(i)), {}, simd::lane_of(wholes.inverted, i)};
    const simd::Deformation<DoubleLanes> deformations =
        corner_deformations(law.model, whole, corner_gradients(*placed.rest, placed.corners, placed.offsets));
    const simd::Symmetric3<DoubleLanes> free = symmetric_lanes(placed.stress_free);
    set_lane(wholes.strain, i, mean_of(deformations.strain));
    set_lane(mean_free, i, mean_of(free));
    const simd::State<DoubleLanes> found = simd::state_of(law, deformations, free);
    states[i].mean.energy_density = 0;
    for (int v = 0; v < 4; ++v) {
      states[i].state.corners[v] = found.of(v);
      states[i].mean.energy_density += states[i].state.corners[v].energy_density;
    }
    if (plastic) read_flowed(law, *plastic, deformations, placed.stress_free, states[i].state);
  }
  const simd::State<DoubleLanes> means = simd::state_of(law, wholes, mean_free);
  for (int i = 0; i < 4; ++i) {
    const double energy_densities = states[i].mean.energy_density;
    states[i].mean = means.of(i);
    states[i].mean.energy_density = 0.8 * states[i].mean.energy_density + 0.05 * energy_densities;
    states[i].mean_cauchy_stress = means.cauchy_stress.of(i);
  }
  return states;
}

QuadraticForces quadratic_forces(const RestElement& rest, const QuadraticState& state) {
  return {-state.corner_traction * rest.shape_gradients, state.edge_forces};
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
  set_forces(rest, weighted_stresses(rest, state.corners), state);
  return quadratic_forces(rest, state);
}

}  // namespace griffith
