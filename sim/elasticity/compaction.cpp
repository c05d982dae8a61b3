#include "sim/elasticity/compaction.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace griffith {
namespace {

VolumeEnergy ogden(double modulus, double onset, double ratio) {
  const double r = ratio / onset, square = 1 / (r * r);
  return {modulus / 4 * (square - 1 + 2 * std::log(r)), modulus / (2 * onset) * (1 - square) / r,
          modulus / (2 * onset * onset) * (3 * square - 1) * square};
}

/// Returns J₀.
double onset_of(ElementModel model) {
  constexpr double kFlat = 0.3, kGreenTurns = 0.57735026918962576;  // 1/√3
  return model == ElementModel::green_strain ? kGreenTurns : kFlat;
}

}  // namespace

bool is_compacted_at(const ElasticLaw& law, double volume_ratio) {
  return law.compaction > 0 && volume_ratio < onset_of(law.model);
}

VolumeEnergy volume_energy(const ElasticLaw& law, double ratio) {
  constexpr double kParabola = 0.02;  // of the onset
  const double onset = onset_of(law.model), least = kParabola * onset;
  if (ratio >= least) return ogden(law.compaction, onset, ratio);
  const VolumeEnergy last = ogden(law.compaction, onset, least);
  const double beyond = ratio - least;
  return {last.value + beyond * (last.slope + 0.5 * beyond * last.curvature), last.slope + beyond * last.curvature,
          last.curvature};
}

Compaction compaction_of(const ElasticLaw& law, const Mat3& strain, bool inverted) {
  const bool is_green = law.model == ElementModel::green_strain && !inverted;
  const double onset = onset_of(law.model);
  const Mat3 stretch = Mat3::Identity() + (is_green ? 2 : 1) * strain;  // FᵀF, or A of F = Q A
  const double determinant = stretch.determinant(), ratio = is_green ? std::sqrt(determinant) : determinant;
  if (!(ratio < onset)) return {};
  const VolumeEnergy energy = volume_energy(law, ratio);
  const Mat3 change = is_green ? Mat3(cofactor(stretch) / ratio) : cofactor(stretch);  // B⁻¹ ∂J/∂F
  // Of the energy's second derivative (U″J² + U′J) tr(l)² − U′J (|sym l|² − |skew l|²), l = dF F⁻¹, the first term is
  // κ r⁻² tr(l)², and the second nearly half of it, for a turn that is left out.
  const double stiffness = ratio > 0 ? energy.curvature + energy.slope / ratio : 0;
  return {energy.slope * change, std::sqrt(std::max(stiffness, 0.5 * energy.curvature)) * change, energy.value};
}

}  // namespace griffith
