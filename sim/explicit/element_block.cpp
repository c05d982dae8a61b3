#include "sim/explicit/element_block.h"

#include "sim/explicit/block_kernel.h"

namespace griffith::explicit_dynamics {
namespace {

void write_forces(const ElementBlock& block, const Matrix p, Lanes stress, Quad* forces) {
  Lanes f[3][3], sum[3] = {};
  for (int corner = 0; corner < 3; ++corner)
    for (int i = 0; i < 3; ++i) {
      const auto& g = block.gradients[corner];
      f[corner][i] = -(p[i][0] * g[0] + p[i][1] * g[1] + p[i][2] * g[2]);
      sum[i] -= f[corner][i];
    }
  scatter(sum[0], sum[1], sum[2], stress, forces, 4);
  for (int corner = 0; corner < 3; ++corner)
    scatter(f[corner][0], f[corner][1], f[corner][2], stress, forces + corner + 1, 4);
}

/// Returns the factor of the work density of elastic strains. Those of slivers are a fraction of the strains in which
/// stresses do work.
Lanes weight_of(const ElementBlock& block) {
  return block.stiffness > broadcast(0) ? block.volume / block.stiffness : broadcast(0);
}

/// Adds the work of the preceding call; `rate` is that of the present one.
void measure(const BlockLaw& law, const ElementBlock& block, const Symmetric rate, float viscosity, ViscousWork& work) {
  Symmetric both;
  for (int e = 0; e < 6; ++e) both[e] = work.rate[e] + rate[e];
  work.work += broadcast(0.5F * viscosity) * weight_of(block) * work_density(law, work.rate, both);
  for (int e = 0; e < 6; ++e) work.rate[e] = rate[e];
}

bool has_offsets(const ElementBlock& block) {
  Lanes squares = {};
  for (int e = 0; e < 6; ++e) squares += block.offset[e] * block.offset[e];
  float sum = 0;
  for (int lane = 0; lane < kLanes; ++lane) sum += squares[lane];
  return sum > 0;
}

/// Adds the traction that turning frames add to `stress` (turning_traction()) to the product R sigma, R = I + `frame`.
void add_turning(const Matrix h, const Matrix frame, const Symmetric stress, Matrix product) {
  Matrix k, moments;
  stretch(frame, h, k);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      moments[i][j] = k[i][0] * stress[kEntry[0][j]] + k[i][1] * stress[kEntry[1][j]] + k[i][2] * stress[kEntry[2][j]];
  const Lanes axial[3] = {moments[1][2] - moments[2][1], moments[2][0] - moments[0][2], moments[0][1] - moments[1][0]};
  TurnOfAxial turn_of;
  Lanes z[3];
  turn_of_axial(k, turn_of);
  multiply(turn_of, axial, z);
  for (int i = 0; i < 3; ++i) z[i] += z[i];
  const Matrix skew = {{Lanes{}, z[2], -z[1]}, {-z[2], Lanes{}, z[0]}, {z[1], -z[0], Lanes{}}};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      product[i][j] += skew[i][j] + frame[i][0] * skew[0][j] + frame[i][1] * skew[1][j] + frame[i][2] * skew[2][j];
}

template <ElementModel model>
void force_elements_of(const BlockLaw& law, ElementBlock& block, const WideQuad* displacements, Quad* forces,
                       ViscousWork& work, float viscosity, bool finds_largest) {
  Matrix h, rotation, product;
  Symmetric strain, stress, rate;
  displacement_gradient(block, displacements, h);
  if constexpr (model == ElementModel::corotational) {
    corotational_strain(h, block.rotation, rotation, strain);
  } else {
    green_strain(h, strain);
  }
  for (int e = 0; e < 6; ++e) strain[e] = block.stiffness * (strain[e] - block.offset[e]);
  const Lanes largest = finds_largest ? max(largest_stress(law, strain), 0) : Lanes{};
  for (int e = 0; e < 6; ++e) {
    rate[e] = strain[e] - block.strain[e];
    block.strain[e] = strain[e];
    strain[e] += broadcast(law.viscosity) * rate[e];
  }
  measure(law, block, rate, viscosity, work);
  const Lanes pressure = broadcast(law.lambda) * (strain[0] + strain[1] + strain[2]);
  for (int e = 0; e < 6; ++e) {
    stress[e] = broadcast(2 * law.mu) * strain[e];
    if (e < 3) stress[e] += pressure;
    stress[e] *= block.volume;
  }
  carry(model == ElementModel::corotational ? rotation : h, stress, product);
  if (model == ElementModel::corotational && has_offsets(block)) add_turning(h, rotation, stress, product);
  write_forces(block, product, largest, forces);
}

}  // namespace

void force_elements(const BlockLaw& law, ElementBlock& block, const WideQuad* displacements, Quad* forces,
                    ViscousWork& work, float viscosity, bool finds_largest) {
  const auto force = law.model == ElementModel::corotational ? force_elements_of<ElementModel::corotational>
                                                             : force_elements_of<ElementModel::green_strain>;
  force(law, block, displacements, forces, work, viscosity, finds_largest);
}

Lanes work_of_last(const BlockLaw& law, const ElementBlock& block, const ViscousWork& work) {
  return broadcast(0.5F * law.viscosity) * weight_of(block) * work_density(law, work.rate, work.rate);
}

void settle_elements(const BlockLaw& law, ElementBlock& block, const WideQuad* displacements) {
  constexpr int kNewtonSteps = 8;  // quadratic convergence: many more than rotations of some degrees need
  Matrix h, frame;
  displacement_gradient(block, displacements, h);
  if (law.model == ElementModel::corotational) {
    for (int i = 0; i < kNewtonSteps; ++i) follow_rotation(h, block.rotation);
    find_lost_rotations(h, block.rotation);
    corotational_strain(h, block.rotation, frame, block.strain);
  } else {
    green_strain(h, block.strain);
  }
  for (int e = 0; e < 6; ++e) {
    const Lanes total = block.strain[e], elastic = total - block.offset[e];
    const Lanes softer = block.stiffness > broadcast(0) ? total - elastic / block.stiffness : broadcast(0);
    block.offset[e] = block.stiffness < broadcast(1) ? softer : block.offset[e];
    block.strain[e] = block.stiffness > broadcast(0) ? elastic : broadcast(0);
  }
}

}  // namespace griffith::explicit_dynamics
