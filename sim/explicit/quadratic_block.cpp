#include "sim/explicit/quadratic_block.h"

#include "sim/core/tet_edge_corners.h"
#include "sim/explicit/block_kernel.h"

namespace griffith::explicit_dynamics {
namespace {

/// Computes the gradients of the shape functions of all corners.
void shape_gradients(const ElementBlock& block, Lanes g[4][3]) {
  for (int j = 0; j < 3; ++j) {
    for (int corner = 0; corner < 3; ++corner) g[corner + 1][j] = block.gradients[corner][j];
    g[0][j] = -(g[1][j] + g[2][j] + g[3][j]);
  }
}

void edge_offset(const QuadraticBlock& quadratic, const WideQuad* offsets, int edge, Lanes w[3]) {
  Quad rows[kLanes];
  for (int lane = 0; lane < kLanes; ++lane)
    rows[lane] = __builtin_convertvector(offsets[quadratic.edges[edge][lane]], Quad);
  transpose(rows, w);
}

/// Computes (I + A) v.
void turn(const Matrix a, const Lanes v[3], Lanes turned[3]) {
  for (int i = 0; i < 3; ++i) turned[i] = v[i] + a[i][0] * v[0] + a[i][1] * v[1] + a[i][2] * v[2];
}

/// Computes (I + A)ᵀ v.
void turn_back(const Matrix a, const Lanes v[3], Lanes turned[3]) {
  for (int i = 0; i < 3; ++i) turned[i] = v[i] + a[0][i] * v[0] + a[1][i] * v[1] + a[2][i] * v[2];
}

/// Edges of each corner, and the corners at their other ends.
constexpr int kEdgesAt[4][3] = {{0, 1, 2}, {0, 3, 4}, {1, 3, 5}, {2, 4, 5}};
constexpr int kOtherEnds[4][3] = {{1, 2, 3}, {0, 2, 3}, {0, 1, 3}, {0, 1, 2}};

/// Corotational turning: all corners have the frame of F_0, that of the corners' displacements.
struct TurningFrame {
  Matrix frame;         ///< R − I
  Matrix stretch;       ///< RᵀF_0 − I
  TurnOfAxial turn_of;  ///< turn_of_axial() of the last step of the rotation
  Lanes w[6][3];        ///< Rᵀ times the offsets of the edges [m]
};

/// Computes the turning of a rotation that has been updated.
void turn_frame(const ElementBlock& block, const QuadraticBlock& quadratic, const WideQuad* offsets, const Matrix whole,
                TurningFrame& turning) {
  rotation_less_identity(block.rotation, turning.frame);
  stretch(turning.frame, whole, turning.stretch);
  for (int edge = 0; edge < 6; ++edge) {
    Lanes w[3];
    edge_offset(quadratic, offsets, edge, w);
    turn_back(turning.frame, w, turning.w[edge]);
  }
}

/// Computes the strain at a corner, sym(RᵀF_v) − I with F_v = F_0 + 4 Σ w_vj g_jᵀ.
inline void corotational_strain(const TurningFrame& turning, const Lanes g[4][3], int corner, Symmetric strain) {
  const Lanes half = broadcast(0.5F), two = broadcast(2);
  const Matrix& k = turning.stretch;
  Lanes e[6] = {half * k[0][0],
                half * k[1][1],
                half * k[2][2],
                half * (k[0][1] + k[1][0]),
                half * (k[1][2] + k[2][1]),
                half * (k[0][2] + k[2][0])};
  Lanes sum[6] = {};
  for (int i = 0; i < 3; ++i) {
    const Lanes* w = turning.w[kEdgesAt[corner][i]];
    const Lanes* n = g[kOtherEnds[corner][i]];
    sum[0] += w[0] * n[0], sum[1] += w[1] * n[1], sum[2] += w[2] * n[2];
    sum[3] += w[0] * n[1] + w[1] * n[0];
    sum[4] += w[1] * n[2] + w[2] * n[1];
    sum[5] += w[0] * n[2] + w[2] * n[0];
  }
  for (int i = 0; i < 6; ++i) strain[i] = (i < 3 ? e[i] + e[i] + two * two * sum[i] : e[i] + two * sum[i]);
}

/// Computes H_v = F_v − I of the corners: that of the corners' displacements, and 4 w ⊗ g of the edges.
void corner_gradients(const QuadraticBlock& quadratic, const WideQuad* offsets, const Lanes g[4][3], const Matrix whole,
                      Matrix h[4]) {
  for (int v = 0; v < 4; ++v)
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) h[v][i][j] = whole[i][j];
  for (int edge = 0; edge < 6; ++edge) {
    const auto [p, q] = kTetEdges[edge];
    Lanes offset[3];
    edge_offset(quadratic, offsets, edge, offset);
    for (int i = 0; i < 3; ++i) {
      const Lanes w = broadcast(4) * offset[i];
      for (int j = 0; j < 3; ++j) {
        h[p][i][j] += w * g[q][j];
        h[q][i][j] += w * g[p][j];
      }
    }
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

/// Sums over the corners in find_stress().
struct CornerSums {
  Symmetric stress = {};            ///< [Pa]
  Symmetric before = {}, now = {};  ///< rates of strain in the last call and in this one
  Lanes work = {};
};

/// Updates the strain at a corner, replaces it by the stress, viscous stress included, and adds to the sums. Returns
/// the largest principal stress, if asked for.
inline Lanes find_stress(const BlockLaw& law, int v, bool finds_largest, QuadraticBlock& quadratic, Symmetric s,
                         CornerSums& sums) {
  Symmetric rate, both;
  for (int e = 0; e < 6; ++e) s[e] -= quadratic.offset[v][e];
  const Lanes largest = finds_largest ? max(largest_stress(law, s), 0) : Lanes{};
  for (int e = 0; e < 6; ++e) {
    rate[e] = s[e] - quadratic.strain[v][e];
    quadratic.strain[v][e] = s[e];
    s[e] += broadcast(law.viscosity) * rate[e];
  }
  for (int e = 0; e < 6; ++e) {
    const Lanes before = quadratic.rate[v][e];
    both[e] = before + rate[e];
    sums.before[e] += before, sums.now[e] += rate[e];
  }
  sums.work += work_density(law, quadratic.rate[v], both);
  const Lanes pressure = broadcast(law.lambda) * (s[0] + s[1] + s[2]);
  for (int e = 0; e < 6; ++e) {
    quadratic.rate[v][e] = rate[e];
    s[e] *= broadcast(2 * law.mu);
    if (e < 3) s[e] += pressure;
    sums.stress[e] += s[e];
  }
  return largest;
}

/// Finishes after the last corner: accounts for the work of the preceding call, and replaces stresses by V/20 (σ_v +
/// Σ σ), their sum by V/4 Σ σ.
inline void finish_stresses(const BlockLaw& law, const ElementBlock& block, float viscosity, Symmetric s[4],
                            CornerSums& sums, ViscousWork& work) {
  Symmetric both;
  for (int e = 0; e < 6; ++e) both[e] = sums.before[e] + sums.now[e];
  const Lanes weight = broadcast(0.05F) * block.volume;
  work.work += broadcast(0.5F * viscosity) * weight * (sums.work + work_density(law, sums.before, both));
  for (int e = 0; e < 6; ++e) {
    for (int v = 0; v < 4; ++v) s[v][e] = weight * (s[v][e] + sums.stress[e]);
    sums.stress[e] *= broadcast(0.25F) * block.volume;
  }
}

/// Writes the forces −P g of a total P on the corners.
void write_corners(const Lanes g[4][3], const Matrix total, const Lanes largest[4], Quad* forces) {
  Lanes f[3], sum[3] = {};
  for (int corner = 1; corner < 4; ++corner) {
    for (int i = 0; i < 3; ++i) {
      f[i] = -(total[i][0] * g[corner][0] + total[i][1] * g[corner][1] + total[i][2] * g[corner][2]);
      sum[i] -= f[i];
    }
    scatter(f[0], f[1], f[2], largest[corner], forces + corner, 4);
  }
  scatter(sum[0], sum[1], sum[2], largest[0], forces, 4);
}

/// Writes the forces on edges, −4 R (σ_p g_q + σ_q g_p). Adds the axial vectors of their moments about F_0, −w fᵀ, to
/// `moments`; all in the frame.
void write_turned_edges(const TurningFrame& turning, const Lanes g[4][3], const Symmetric s[4], Lanes moments[3],
                        Quad* edge_forces) {
  for (int edge = 0; edge < 6; ++edge) {
    const auto [p, q] = kTetEdges[edge];
    Lanes of_p[3], of_q[3], f[3], turned[3];
    multiply(s[p], g[q], of_p);
    multiply(s[q], g[p], of_q);
    for (int i = 0; i < 3; ++i) f[i] = broadcast(-4) * (of_p[i] + of_q[i]);
    const Lanes* w = turning.w[edge];
    moments[0] -= w[1] * f[2] - w[2] * f[1];
    moments[1] -= w[2] * f[0] - w[0] * f[2];
    moments[2] -= w[0] * f[1] - w[1] * f[0];
    turn(turning.frame, f, turned);
    scatter(turned[0], turned[1], turned[2], Lanes{}, edge_forces + edge, 6);
  }
}

/// Computes the total of the stresses in the frame, R (S + Z) with the contribution Z of the rotating frame
/// (turning_traction() of quadratic_element.cpp). `moments`: axial vector of Σ (RᵀF_v − I) σ_v.
void turn_total(const TurningFrame& turning, const Symmetric s, const Lanes moments[3], Matrix total) {
  Lanes half[3];
  multiply(turning.turn_of, moments, half);
  const Lanes z0 = half[0] + half[0], z1 = half[1] + half[1], z2 = half[2] + half[2];
  const Matrix sum = {{s[0], s[3] + z2, s[5] - z1}, {s[3] - z2, s[1], s[4] + z0}, {s[5] + z1, s[4] - z0, s[2]}};
  const Matrix& b = turning.frame;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      total[i][j] = sum[i][j] + b[i][0] * sum[0][j] + b[i][1] * sum[1][j] + b[i][2] * sum[2][j];
}

void corotational_forces(const BlockLaw& law, ElementBlock& block, QuadraticBlock& quadratic,
                         const QuadraticDisplacements& displacements, Quad* forces, Quad* edge_forces,
                         ViscousWork& work, float viscosity, bool finds_largest) {
  Matrix whole, total;
  Lanes g[4][3], largest[4];
  Symmetric s[4];
  CornerSums sums;
  TurningFrame turning;
  shape_gradients(block, g);
  displacement_gradient(block, displacements.nodes, whole);
  follow_rotation(whole, block.rotation, turning.turn_of);
  turn_frame(block, quadratic, displacements.edges, whole, turning);
  for (int v = 0; v < 4; ++v) {
    corotational_strain(turning, g, v, s[v]);
    largest[v] = find_stress(law, v, finds_largest, quadratic, s[v], sums);
  }
  finish_stresses(law, block, viscosity, s, sums, work);
  const Symmetric& sum = sums.stress;
  const auto moment = [&](int i, int j) {
    const Lanes* k = turning.stretch[i];
    return k[0] * sum[kEntry[0][j]] + k[1] * sum[kEntry[1][j]] + k[2] * sum[kEntry[2][j]];
  };
  Lanes moments[3] = {moment(1, 2) - moment(2, 1), moment(2, 0) - moment(0, 2), moment(0, 1) - moment(1, 0)};
  write_turned_edges(turning, g, s, moments, edge_forces);
  turn_total(turning, sum, moments, total);
  write_corners(g, total, largest, forces);
}

void green_forces(const BlockLaw& law, ElementBlock& block, QuadraticBlock& quadratic,
                  const QuadraticDisplacements& displacements, Quad* forces, Quad* edge_forces, ViscousWork& work,
                  float viscosity, bool finds_largest) {
  Matrix whole, h[4], p[4], total = {};
  Lanes g[4][3], largest[4];
  Symmetric s[4];
  CornerSums sums;
  shape_gradients(block, g);
  displacement_gradient(block, displacements.nodes, whole);
  corner_gradients(quadratic, displacements.edges, g, whole, h);
  for (int v = 0; v < 4; ++v) {
    green_strain(h[v], s[v]);
    largest[v] = find_stress(law, v, finds_largest, quadratic, s[v], sums);
  }
  finish_stresses(law, block, viscosity, s, sums, work);
  for (int v = 0; v < 4; ++v) {
    carry(h[v], s[v], p[v]);
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) total[i][j] += p[v][i][j];
  }
  write_corners(g, total, largest, forces);
  for (int edge = 0; edge < 6; ++edge) {
    const auto [a, b] = kTetEdges[edge];
    Lanes f[3];
    for (int i = 0; i < 3; ++i)
      f[i] = broadcast(-4) * (p[a][i][0] * g[b][0] + p[a][i][1] * g[b][1] + p[a][i][2] * g[b][2] +
                              p[b][i][0] * g[a][0] + p[b][i][1] * g[a][1] + p[b][i][2] * g[a][2]);
    scatter(f[0], f[1], f[2], Lanes{}, edge_forces + edge, 6);
  }
}

}  // namespace

void force_quadratic_elements(const BlockLaw& law, ElementBlock& block, QuadraticBlock& quadratic,
                              const QuadraticDisplacements& displacements, Quad* forces, Quad* edge_forces,
                              ViscousWork& work, float viscosity, bool finds_largest) {
  const auto force = law.model == ElementModel::corotational ? corotational_forces : green_forces;
  force(law, block, quadratic, displacements, forces, edge_forces, work, viscosity, finds_largest);
}

Lanes work_of_last(const BlockLaw& law, const ElementBlock& block, const QuadraticBlock& quadratic) {
  return broadcast(0.5F * law.viscosity) * corner_work(law, block, quadratic.rate, quadratic.rate);
}

void settle_quadratic_elements(const BlockLaw& law, ElementBlock& block, QuadraticBlock& quadratic,
                               const QuadraticDisplacements& displacements) {
  constexpr int kNewtonSteps = 8;  // as settle_elements()
  Matrix whole;
  Lanes g[4][3];
  shape_gradients(block, g);
  displacement_gradient(block, displacements.nodes, whole);
  if (law.model == ElementModel::corotational) {
    TurningFrame turning;
    for (int i = 0; i < kNewtonSteps; ++i) follow_rotation(whole, block.rotation);
    find_lost_rotations(whole, block.rotation);
    turn_frame(block, quadratic, displacements.edges, whole, turning);
    for (int v = 0; v < 4; ++v) corotational_strain(turning, g, v, quadratic.strain[v]);
  } else {
    Matrix h[4];
    corner_gradients(quadratic, displacements.edges, g, whole, h);
    for (int v = 0; v < 4; ++v) green_strain(h[v], quadratic.strain[v]);
  }
  for (int v = 0; v < 4; ++v)
    for (int e = 0; e < 6; ++e) {
      quadratic.strain[v][e] -= quadratic.offset[v][e];
      quadratic.rate[v][e] = broadcast(0);
    }
}

}  // namespace griffith::explicit_dynamics
