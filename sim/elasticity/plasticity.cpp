#include "sim/elasticity/plasticity.h"

#include <cmath>

namespace griffith {

std::optional<PlasticLaw> plastic_law(const Material& material) {
  if (!material.yield_strength) return std::nullopt;
  return PlasticLaw{*material.yield_strength / (std::sqrt(6.0) * shear_modulus(material)), material.plastic_limit};
}

Mat3 flow(const PlasticLaw& law, const ElementDeformation& deformation, const Mat3& plastic_strain) {
  Mat3 deviator = deformation.strain - plastic_strain;
  deviator.diagonal().array() -= deviator.trace() / 3;
  const double norm = deviator.norm();
  if (deformation.inverted || !(norm > law.yield_strain)) return plastic_strain;
  const Mat3 flowed = plastic_strain + (1 - law.yield_strain / norm) * deviator;
  const double length = flowed.norm();
  return length > law.limit ? Mat3(law.limit / length * flowed) : flowed;
}

double yield_work(const PlasticLaw& law, double shear_modulus, const Mat3& flowed) {
  return 2 * shear_modulus * law.yield_strain * flowed.norm();
}

}  // namespace griffith
