#include "sim/explicit/quadratic_block.h"

#include "sim/core/tet_edge_corners.h"
#include "sim/explicit/block_kernel.h"

namespace griffith::explicit_dynamics {
namespace {

/// Computes H_v = F_v − I of the corners: that of the corners' displacements, and 4 w ⊗ g of the edges.
void corner_gradients(const ElementBlock& block, const QuadraticBlock& quadratic,
                      const QuadraticDisplacements& displacements, Matrix whole, Matrix h[4]) {
  displacement_gradient(block, displacements.nodes, whole);
  for (int v = 0; v < 4; ++v)
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) h[v][i][j] = whole[i][j];
  Lanes g[4][3];
  for (int j = 0; j < 3; ++j) {
    for (int corner = 0; corner < 3; ++corner) g[corner + 1][j] = block.gradients[corner][j];
    g[0][j] = -(g[1][j] + g[2][j] + g[3][j]);
  }
  for (int edge = 0; edge < 6; ++edge) {
    const auto [p, q] = kTetEdges[edge];
    Quad rows[kLanes];
    for (int lane = 0; lane < kLanes; ++lane)
      rows[lane] = __builtin_convertvector(displacements.edges[quadratic.edges[edge][lane]], Quad);
    Lanes offset[3];
    transpose(rows, offset);
    for (int i = 0; i < 3; ++i) {
      const Lanes w = broadcast(4) * offset[i];
      for (int j = 0; j < 3; ++j) {
        h[p][i][j] += w * g[q][j];
        h[q][i][j] += w * g[p][j];
      }
    }
  }
}

/// Computes the strains at the corners, their common frame less the identity, and K = RᵀF − I of each.
void corotational_strains(const Matrix whole, const Matrix h[4], Lanes rotation[4], Matrix frame, Matrix k[4],
                          Symmetric strains[4]) {
  follow_rotation(whole, rotation);
  rotation_less_identity(rotation, frame);
  for (int v = 0; v < 4; ++v) {
    stretch(frame, h[v], k[v]);
    for (int e = 0; e < 6; ++e)
      strains[v][e] = broadcast(0.5F) * (k[v][kRow[e]][kColumn[e]] + k[v][kColumn[e]][kRow[e]]);
  }
}

/// Returns V/20 times the sum of the work densities of the corners and that of their sums.
Lanes corner_work(const BlockLaw& law, const ElementBlock& block, const Symmetric a[4], const Symmetric b[4]) {
  Symmetric sum_a = {}, sum_b = {};
  Lanes sum = {};
  for (int v = 0; v < 4; ++v) {
    sum += work_density(law, a[v], b[v]);
    for (int e = 0; e < 6; ++e) sum_a[e] += a[v][e], sum_b[e] += b[v][e];
  }
  return broadcast(0.05F) * block.volume * (sum + work_density(law, sum_a, sum_b));
}

void measure(const BlockLaw& law, const ElementBlock& block, const Symmetric rates[4], float viscosity,
             QuadraticBlock& quadratic, ViscousWork& work) {
  Symmetric both[4];
  for (int v = 0; v < 4; ++v)
    for (int e = 0; e < 6; ++e) both[v][e] = quadratic.rate[v][e] + rates[v][e];
  work.work += broadcast(0.5F * viscosity) * corner_work(law, block, quadratic.rate, both);
  for (int v = 0; v < 4; ++v)
    for (int e = 0; e < 6; ++e) quadratic.rate[v][e] = rates[v][e];
}

/// Replaces strains by V/20 (σ_v + Σ σ).
void weighted_stresses(const BlockLaw& law, Lanes volume, Symmetric s[4]) {
  Symmetric sum = {};
  for (int v = 0; v < 4; ++v) {
    const Lanes pressure = broadcast(law.lambda) * (s[v][0] + s[v][1] + s[v][2]);
    for (int e = 0; e < 6; ++e) {
      s[v][e] *= broadcast(2 * law.mu);
      if (e < 3) s[v][e] += pressure;
      sum[e] += s[v][e];
    }
  }
  const Lanes weight = broadcast(0.05F) * volume;
  for (int v = 0; v < 4; ++v)
    for (int e = 0; e < 6; ++e) s[v][e] = weight * (s[v][e] + sum[e]);
}

/// Adds the contribution of the rotating frame (turning_traction() of quadratic_element.cpp). `whole`: K of F_0.
void add_turning(const Matrix frame, const Matrix whole, const Matrix k[4], const Symmetric s[4], Matrix total) {
  const auto moment = [&](int i, int j) {
    Lanes sum = {};
    for (int v = 0; v < 4; ++v)
      for (int l = 0; l < 3; ++l) sum += k[v][i][l] * s[v][kEntry[l][j]];
    return sum;
  };
  const Lanes moments[3] = {moment(1, 2) - moment(2, 1), moment(2, 0) - moment(0, 2), moment(0, 1) - moment(1, 0)};
  Lanes half[3];
  half_turn(whole, moments, half);
  const Lanes zero = {}, z0 = half[0] + half[0], z1 = half[1] + half[1], z2 = half[2] + half[2];
  const Matrix z = {{zero, z2, -z1}, {-z2, zero, z0}, {z1, -z0, zero}};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      total[i][j] += z[i][j] + frame[i][0] * z[0][j] + frame[i][1] * z[1][j] + frame[i][2] * z[2][j];
}

void write_forces(const ElementBlock& block, const Matrix p[4], const Matrix total, const Lanes largest[4],
                  Quad* forces, Quad* edge_forces) {
  Lanes g[4][3], f[3], sum[3] = {};
  for (int j = 0; j < 3; ++j) {
    for (int corner = 0; corner < 3; ++corner) g[corner + 1][j] = block.gradients[corner][j];
    g[0][j] = -(g[1][j] + g[2][j] + g[3][j]);
  }
  for (int corner = 1; corner < 4; ++corner) {
    for (int i = 0; i < 3; ++i) {
      f[i] = -(total[i][0] * g[corner][0] + total[i][1] * g[corner][1] + total[i][2] * g[corner][2]);
      sum[i] -= f[i];
    }
    scatter(f[0], f[1], f[2], largest[corner], forces + corner, 4);
  }
  scatter(sum[0], sum[1], sum[2], largest[0], forces, 4);
  for (int edge = 0; edge < 6; ++edge) {
    const auto [a, b] = kTetEdges[edge];
    for (int i = 0; i < 3; ++i)
      f[i] = broadcast(-4) * (p[a][i][0] * g[b][0] + p[a][i][1] * g[b][1] + p[a][i][2] * g[b][2] +
                              p[b][i][0] * g[a][0] + p[b][i][1] * g[a][1] + p[b][i][2] * g[a][2]);
    scatter(f[0], f[1], f[2], Lanes{}, edge_forces + edge, 6);
  }
}

template <ElementModel model>
void force_quadratic_elements_of(const BlockLaw& law, ElementBlock& block, QuadraticBlock& quadratic,
                                 const QuadraticDisplacements& displacements, Quad* forces, Quad* edge_forces,
                                 ViscousWork& work, float viscosity) {
  Matrix whole, h[4], frame, k[4], p[4], total = {};
  Symmetric strains[4], rates[4];
  Lanes largest[4];
  corner_gradients(block, quadratic, displacements, whole, h);
  if constexpr (model == ElementModel::corotational) {
    corotational_strains(whole, h, block.rotation, frame, k, strains);
  } else {
    for (int v = 0; v < 4; ++v) green_strain(h[v], strains[v]);
  }
  for (int v = 0; v < 4; ++v) {
    for (int e = 0; e < 6; ++e) strains[v][e] -= quadratic.offset[v][e];
    largest[v] = max(largest_stress(law, strains[v]), 0);
    for (int e = 0; e < 6; ++e) {
      rates[v][e] = strains[v][e] - quadratic.strain[v][e];
      quadratic.strain[v][e] = strains[v][e];
      strains[v][e] += broadcast(law.viscosity) * rates[v][e];
    }
  }
  measure(law, block, rates, viscosity, quadratic, work);
  weighted_stresses(law, block.volume, strains);
  for (int v = 0; v < 4; ++v) {
    carry(model == ElementModel::corotational ? frame : h[v], strains[v], p[v]);
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) total[i][j] += p[v][i][j];
  }
  if constexpr (model == ElementModel::corotational) {
    Matrix stretch_of_corners;
    stretch(frame, whole, stretch_of_corners);
    add_turning(frame, stretch_of_corners, k, strains, total);
  }
  write_forces(block, p, total, largest, forces, edge_forces);
}

}  // namespace

void force_quadratic_elements(const BlockLaw& law, ElementBlock& block, QuadraticBlock& quadratic,
                              const QuadraticDisplacements& displacements, Quad* forces, Quad* edge_forces,
                              ViscousWork& work, float viscosity) {
  if (law.model == ElementModel::corotational) {
    force_quadratic_elements_of<ElementModel::corotational>(law, block, quadratic, displacements, forces, edge_forces,
                                                            work, viscosity);
  } else {
    force_quadratic_elements_of<ElementModel::green_strain>(law, block, quadratic, displacements, forces, edge_forces,
                                                            work, viscosity);
  }
}

Lanes work_of_last(const BlockLaw& law, const ElementBlock& block, const QuadraticBlock& quadratic) {
  return broadcast(0.5F * law.viscosity) * corner_work(law, block, quadratic.rate, quadratic.rate);
}

void settle_quadratic_elements(const BlockLaw& law, ElementBlock& block, QuadraticBlock& quadratic,
                               const QuadraticDisplacements& displacements) {
  constexpr int kNewtonSteps = 8;  // as settle_elements()
  Matrix whole, h[4], frame, k[4];
  corner_gradients(block, quadratic, displacements, whole, h);
  if (law.model == ElementModel::corotational) {
    for (int i = 0; i < kNewtonSteps; ++i) follow_rotation(whole, block.rotation);
    find_lost_rotations(whole, block.rotation);
    corotational_strains(whole, h, block.rotation, frame, k, quadratic.strain);
  } else {
    for (int v = 0; v < 4; ++v) green_strain(h[v], quadratic.strain[v]);
  }
  for (int v = 0; v < 4; ++v)
    for (int e = 0; e < 6; ++e) {
      quadratic.strain[v][e] -= quadratic.offset[v][e];
      quadratic.rate[v][e] = broadcast(0);
    }
}

}  // namespace griffith::explicit_dynamics
