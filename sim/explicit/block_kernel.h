#pragma once

#include "sim/elasticity/polar_decomposition.h"
#include "sim/explicit/element_block.h"

// Kernels common to blocks of linear and quadratic elements: eight side by side.

namespace griffith::explicit_dynamics {

using Matrix = Lanes[3][3];
using Symmetric = Lanes[6];

constexpr int kRow[6] = {0, 1, 2, 0, 1, 0}, kColumn[6] = {0, 1, 2, 1, 2, 2};
constexpr int kEntry[3][3] = {{0, 3, 5}, {3, 1, 4}, {5, 4, 2}};

/// Computes H = F − I from the corners. Edges are subtracted in double precision; the rest is in single precision.
inline void displacement_gradient(const ElementBlock& block, const WideQuad* displacements, Matrix h) {
  Lanes edges[3][3];
  for (int corner = 0; corner < 3; ++corner) {
    Quad rows[kLanes];
    for (int lane = 0; lane < kLanes; ++lane)
      rows[lane] = __builtin_convertvector(
          displacements[block.nodes[corner + 1][lane]] - displacements[block.nodes[0][lane]], Quad);
    transpose(rows, edges[corner]);
  }
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      h[i][j] = edges[0][i] * block.gradients[0][j] + edges[1][i] * block.gradients[1][j] +
                edges[2][i] * block.gradients[2][j];
}

/// Computes B = R − I of a unit quaternion.
inline void rotation_less_identity(const Lanes q[4], Matrix b) {
  const Lanes x = q[0] + q[0], y = q[1] + q[1], z = q[2] + q[2];
  b[0][0] = -(y * q[1] + z * q[2]), b[1][1] = -(x * q[0] + z * q[2]), b[2][2] = -(x * q[0] + y * q[1]);
  b[0][1] = x * q[1] - z * q[3], b[1][0] = x * q[1] + z * q[3];
  b[0][2] = x * q[2] + y * q[3], b[2][0] = x * q[2] - y * q[3];
  b[1][2] = y * q[2] - x * q[3], b[2][1] = y * q[2] + x * q[3];
}

/// Computes K = RᵀF − I = Bᵀ + H + BᵀH.
inline void stretch(const Matrix b, const Matrix h, Matrix k) {
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) k[i][j] = b[j][i] + h[i][j] + b[0][i] * h[0][j] + b[1][i] * h[1][j] + b[2][i] * h[2][j];
}

/// Map from the axial vector of K = RᵀF − I to half of the small rotation that makes RᵀF symmetric.
struct TurnOfAxial {
  Symmetric cofactors;
  Lanes factor;
};

/// Computes ½ (tr(S) I − S)⁻¹, S the symmetric part of I + K with K = RᵀF − I. It maps the axial vector of K to half of
/// the small rotation that makes RᵀF symmetric. Zero for a flattened element, which keeps its rotation.
inline void turn_of_axial(const Matrix k, TurnOfAxial& turn) {
  const Lanes two = broadcast(2), half = broadcast(0.5F);
  const Lanes m00 = two + k[1][1] + k[2][2], m11 = two + k[0][0] + k[2][2], m22 = two + k[0][0] + k[1][1];
  const Lanes m01 = -half * (k[0][1] + k[1][0]), m02 = -half * (k[0][2] + k[2][0]), m12 = -half * (k[1][2] + k[2][1]);
  const Lanes c00 = m11 * m22 - m12 * m12, c01 = m02 * m12 - m01 * m22, c02 = m01 * m12 - m02 * m11;
  const Lanes c11 = m00 * m22 - m02 * m02, c12 = m01 * m02 - m00 * m12, c22 = m00 * m11 - m01 * m01;
  const Lanes determinant = m00 * c00 + m01 * c01 + m02 * c02;
  const Lanes factor = determinant > broadcast(0.05F) ? half / determinant : broadcast(0);
  turn = {{c00, c11, c22, c01, c12, c02}, factor};
}

/// Computes the product of a symmetric tensor and a vector.
inline void multiply(const Symmetric s, const Lanes v[3], Lanes product[3]) {
  product[0] = s[0] * v[0] + s[3] * v[1] + s[5] * v[2];
  product[1] = s[3] * v[0] + s[1] * v[1] + s[4] * v[2];
  product[2] = s[5] * v[0] + s[4] * v[1] + s[2] * v[2];
}

inline void multiply(const TurnOfAxial& turn_of, const Lanes axial[3], Lanes turn[3]) {
  multiply(turn_of.cofactors, axial, turn);
  for (int i = 0; i < 3; ++i) turn[i] = turn_of.factor * turn[i];
}

/// Rotates R toward the rotation of F. `turn_of`: turn_of_axial() before.
inline void follow_rotation(const Matrix h, Lanes q[4], TurnOfAxial& turn_of) {
  Matrix b, k;
  rotation_less_identity(q, b);
  stretch(b, h, k);
  const Lanes a[3] = {k[2][1] - k[1][2], k[0][2] - k[2][0], k[1][0] - k[0][1]};
  Lanes turn[3];
  turn_of_axial(k, turn_of);
  multiply(turn_of, a, turn);
  const Lanes &x = turn[0], &y = turn[1], &z = turn[2];
  const Lanes p[4] = {q[0], q[1], q[2], q[3]};
  q[0] = p[0] + p[3] * x + p[1] * z - p[2] * y;
  q[1] = p[1] + p[3] * y + p[2] * x - p[0] * z;
  q[2] = p[2] + p[3] * z + p[0] * y - p[1] * x;
  q[3] = p[3] - p[0] * x - p[1] * y - p[2] * z;
  const Lanes norm = broadcast(1) / root(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
  for (int i = 0; i < 4; ++i) q[i] *= norm;
}

inline void follow_rotation(const Matrix h, Lanes q[4]) {
  TurnOfAxial turn_of;
  follow_rotation(h, q, turn_of);
}

/// Finds rotations where Newton's steps fail: after more than about a right angle.
inline void find_lost_rotations(const Matrix h, Lanes q[4]) {
  constexpr float kAsymmetry = 1e-3F, kMinTrace = 1;  // of RᵀF
  Matrix b, k;
  rotation_less_identity(q, b);
  stretch(b, h, k);
  for (int lane = 0; lane < kLanes; ++lane) {
    const Vec3 axial(k[2][1][lane] - k[1][2][lane], k[0][2][lane] - k[2][0][lane], k[1][0][lane] - k[0][1][lane]);
    const float trace = k[0][0][lane] + k[1][1][lane] + k[2][2][lane] + 3;
    if (!(axial.norm() > kAsymmetry || trace < kMinTrace)) continue;
    Mat3 gradient = Mat3::Identity();
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) gradient(i, j) += h[i][j][lane];
    const Quat rotation(polar_rotation(gradient));
    for (int i = 0; i < 4; ++i) q[i][lane] = static_cast<float>(rotation.coeffs()[i]);
  }
}

/// Computes Green's strain ½ (H + Hᵀ + HᵀH). The frame less the identity is H.
inline void green_strain(const Matrix h, Symmetric strain) {
  for (int e = 0; e < 6; ++e) {
    const int i = kRow[e], j = kColumn[e];
    strain[e] = broadcast(0.5F) * (h[i][j] + h[j][i] + h[0][i] * h[0][j] + h[1][i] * h[1][j] + h[2][i] * h[2][j]);
  }
}

/// Computes sym(RᵀF) − I, and the frame R less the identity.
inline void corotational_strain(const Matrix h, Lanes rotation[4], Matrix frame, Symmetric strain) {
  follow_rotation(h, rotation);
  rotation_less_identity(rotation, frame);
  Matrix k;
  stretch(frame, h, k);
  for (int e = 0; e < 6; ++e) strain[e] = broadcast(0.5F) * (k[kRow[e]][kColumn[e]] + k[kColumn[e]][kRow[e]]);
}

/// Returns cos(arccos(r)/3) by a quartic in cos(arccos(r)/2), within 1e-5.
inline Lanes third_cosine(Lanes r) {
  const Lanes t = root(min(max(broadcast(0.5F) + broadcast(0.5F) * r, 0), 1));
  return broadcast(0.50000940F) +
         t * (broadcast(0.57684866F) +
              t * (broadcast(-0.10666834F) + t * (broadcast(0.03862534F) - t * broadcast(0.00882232F))));
}

/// Returns the largest eigenvalue of lambda tr(E) I + 2 mu E; if the law has a strength surface and it is larger, the
/// equivalent_tension(). With the mean p of E's eigenvalues, they are p + 2 q cos((arccos(r) + 2πn) / 3).
inline Lanes largest_stress(const BlockLaw& law, const Symmetric e) {
  const Lanes p = (e[0] + e[1] + e[2]) * broadcast(1.0F / 3);
  const Lanes x = e[0] - p, y = e[1] - p, z = e[2] - p;
  const Lanes square =
      (broadcast(0.5F) * (x * x + y * y + z * z) + e[3] * e[3] + e[4] * e[4] + e[5] * e[5]) * broadcast(1.0F / 3) +
      broadcast(1e-24F);
  const Lanes q = root(square);
  const Lanes determinant =
      x * (y * z - e[4] * e[4]) + e[3] * (e[4] * e[5] - e[3] * z) + e[5] * (e[3] * e[4] - y * e[5]);
  const Lanes r = broadcast(0.5F) * determinant / (square * q);
  const Lanes mean = broadcast(3 * law.lambda + 2 * law.mu) * p;
  const Lanes largest = mean + broadcast(4 * law.mu) * q * third_cosine(r);
  if (law.strength_ratio == 0) return largest;
  const Lanes equivalent =
      broadcast(1.5F * (1 - law.strength_ratio)) * mean + broadcast(3 * (1 + law.strength_ratio) * law.mu) * q;
  return largest > equivalent ? largest : equivalent;
}

/// Computes (I + A) S for the frame I + A.
inline void carry(const Matrix a, const Symmetric s, Matrix product) {
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      product[i][j] =
          s[kEntry[i][j]] + a[i][0] * s[kEntry[0][j]] + a[i][1] * s[kEntry[1][j]] + a[i][2] * s[kEntry[2][j]];
}

/// Returns the work of the stress of strain a in strain b per volume: λ tr(a) tr(b) + 2μ a : b.
inline Lanes work_density(const BlockLaw& law, const Symmetric a, const Symmetric b) {
  const Lanes trace = (a[0] + a[1] + a[2]) * (b[0] + b[1] + b[2]);
  const Lanes normal = a[0] * b[0] + a[1] * b[1] + a[2] * b[2], shear = a[3] * b[3] + a[4] * b[4] + a[5] * b[5];
  return broadcast(law.lambda) * trace + broadcast(2 * law.mu) * (normal + shear + shear);
}

}  // namespace griffith::explicit_dynamics
