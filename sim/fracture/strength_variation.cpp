#include "sim/fracture/strength_variation.h"

#include <cmath>
#include <random>

namespace griffith {

double DirectionalStrength::fraction(const Vec3& normal) const {
  const double cosine = axis.dot(normal);
  return across + (along - across) * cosine * cosine;
}

Mat3 DirectionalStrength::inverse_root() const {
  const Mat3 projector = axis * axis.transpose();
  return projector / std::sqrt(along) + (Mat3::Identity() - projector) / std::sqrt(across);
}

DirectionalStrength directional_strength(const Weakness& weakness, const Vec3& axis) {
  if (weakness.kind == WeaknessKind::layers) return {axis, weakness.strength_ratio, 1};
  return {axis, 1, weakness.strength_ratio};
}

std::vector<double> strength_factors(const StrengthScatter& scatter, const std::vector<double>& volumes) {
  const double m = scatter.weibull_modulus;
  std::mt19937_64 random(static_cast<std::uint64_t>(scatter.seed));
  std::vector<double> factors;
  factors.reserve(volumes.size());
  for (double volume : volumes) {
    // Standard distributions differ between libraries, but 53 random bits in (0, 1) are the same everywhere.
    const double uniform = (static_cast<double>(random() >> 11) + 0.5) * 0x1p-53;
    factors.push_back(std::pow(-std::log(uniform) * scatter.reference_volume / volume, 1 / m) / std::tgamma(1 + 1 / m));
  }
  return factors;
}

}  // namespace griffith
