#include "sim/elasticity/tangent_stiffness.h"

#include <Eigen/LU>
#include <algorithm>

#include "sim/elasticity/compaction.h"
#include "sim/elasticity/polar_decomposition.h"
#include "sim/elasticity/principal_stress.h"

namespace griffith {
namespace {

constexpr int next(int i) { return (i + 1) % 3; }
constexpr int last(int i) { return (i + 2) % 3; }

/// Adds ψ = μ |Σ − I|² + λ/2 tr(Σ − I)².
void add_corotational(const ElasticLaw& law, const Vec3& singular_values, TangentStiffness& tangent) {
  constexpr double kSmallest = 1e-3;  // sum of singular_values: an element flatter than this turns as this one
  const double volumetric = law.lambda * (singular_values.sum() - 3);
  const Vec3 stress = 2 * law.mu * (singular_values - Vec3::Ones()) + Vec3::Constant(volumetric);
  tangent.stretching += 2 * law.mu * Mat3::Identity() + Mat3::Constant(law.lambda);
  tangent.shearing += Vec3::Constant(2 * law.mu);
  for (int i = 0; i < 3; ++i)
    tangent.turning[i] +=
        (stress[next(i)] + stress[last(i)]) / std::max(kSmallest, singular_values[next(i)] + singular_values[last(i)]);
}

/// Adds ψ = μ |E|² + λ/2 tr(E)², E = ½ (Σ² − I).
void add_green(const ElasticLaw& law, const Vec3& singular_values, TangentStiffness& tangent) {
  const Vec3 strain = 0.5 * (singular_values.cwiseAbs2() - Vec3::Ones());
  const Vec3 stress = 2 * law.mu * strain + Vec3::Constant(law.lambda * strain.sum());
  tangent.stretching += law.lambda * singular_values * singular_values.transpose();
  tangent.stretching += (stress + 2 * law.mu * singular_values.cwiseAbs2()).asDiagonal();
  for (int i = 0; i < 3; ++i) {
    const double a = singular_values[next(i)], b = singular_values[last(i)],
                 mean = 0.5 * (stress[next(i)] + stress[last(i)]);
    tangent.shearing[i] += mean + 0.5 * law.mu * (a + b) * (a + b);
    tangent.turning[i] += mean + 0.5 * law.mu * (a - b) * (a - b);
  }
}

/// Adds U(J), J = σ₁ σ₂ σ₃.
void add_volumetric(const VolumeEnergy& energy, const Vec3& singular_values, TangentStiffness& tangent) {
  for (int i = 0; i < 3; ++i) {
    const double slope = energy.slope * singular_values[i];
    tangent.stretching(next(i), last(i)) += slope;
    tangent.stretching(last(i), next(i)) += slope;
    tangent.shearing[i] -= slope;
    tangent.turning[i] += slope;
  }
  const Vec3 gradient(singular_values[1] * singular_values[2], singular_values[2] * singular_values[0],
                      singular_values[0] * singular_values[1]);
  tangent.stretching += energy.curvature * gradient * gradient.transpose();
}

void raise_eigenvalues(double least, TangentStiffness& tangent) {
  tangent.shearing = tangent.shearing.cwiseMax(least);
  tangent.turning = tangent.turning.cwiseMax(least);
  const PrincipalValues found = principal_values(tangent.stretching);
  if (found.values[0] >= least) return;
  const Vec3 raised = found.values.cwiseMax(least);
  tangent.stretching = found.directions * raised.asDiagonal() * found.directions.transpose();
}

}  // namespace

TangentStiffness tangent_stiffness(const ElasticLaw& law, const RestElement& rest, const Corners& corners,
                                   double least) {
  const Mat3 gradient = deformation_gradient(rest, corners), turn = polar_rotation(gradient);
  const Mat3 stretch = turn.transpose() * gradient;
  const PrincipalValues found = principal_values(0.5 * (stretch + stretch.transpose()));
  TangentStiffness tangent;
  tangent.right = found.directions;
  tangent.left = turn * found.directions;
  const double ratio = found.values.prod();
  const bool is_green = law.model == ElementModel::green_strain && ratio > 0;
  is_green ? add_green(law, found.values, tangent) : add_corotational(law, found.values, tangent);
  if (is_compacted_at(law, ratio)) add_volumetric(volume_energy(law, ratio), found.values, tangent);
  raise_eigenvalues(least, tangent);
  return tangent;
}

StiffnessRow TangentStiffness::row(const RestElement& rest, int corner, double factor) const {
  const Corners gradients = right.transpose() * rest.shape_gradients;
  const Vec3 even = 0.5 * (shearing + turning), odd = 0.5 * (shearing - turning);
  const auto g = gradients.col(corner);
  StiffnessRow row;
  for (int j = 0; j < 4; ++j) {
    const auto h = gradients.col(j);
    Mat3 block;
    for (int p = 0; p < 3; ++p) {
      const int q = next(p), r = last(p);
      block(p, p) = stretching(p, p) * g[p] * h[p] + even[r] * g[q] * h[q] + even[q] * g[r] * h[r];
      block(p, q) = stretching(p, q) * g[p] * h[q] + odd[r] * g[q] * h[p];
      block(p, r) = stretching(p, r) * g[p] * h[r] + odd[q] * g[r] * h[p];
    }
    const Mat3 turned = factor * rest.volume * left * block * left.transpose();
    for (int k = 0; k < 3; ++k) row.columns[3 * j + k] = simd::WideQuad{turned(0, k), turned(1, k), turned(2, k), 0};
  }
  return row;
}

}  // namespace griffith
