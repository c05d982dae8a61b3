#include "sim/elasticity/element.h"

#include <Eigen/LU>
#include <cassert>

#include "sim/elasticity/polar_decomposition.h"

namespace griffith {

ElementRest element_rest(const Corners& rest_corners) {
  const Mat3 edges = rest_corners.rightCols<3>().colwise() - rest_corners.col(0);
  const double determinant = edges.determinant();
  assert(determinant > 0 && "meshes are oriented and checked before elements are made");
  const Mat3 inverse = edges.inverse();
  ElementRest rest;
  rest.shape_gradients.rightCols<3>() = inverse.transpose();
  rest.shape_gradients.col(0) = -inverse.transpose().rowwise().sum();
  rest.volume = determinant / 6;
  return rest;
}

ElasticModuli elastic_moduli(const Material& material) { return {lame_lambda(material), shear_modulus(material)}; }

ElementState corotational_state(const ElementRest& rest, const ElasticModuli& moduli, const Corners& corners) {
  const Mat3 gradient = deformation_gradient(rest, corners);
  ElementState state;
  state.rotation = polar_rotation(gradient);
  const Mat3 stretch = state.rotation.transpose() * gradient;
  const Mat3 strain = 0.5 * (stretch + stretch.transpose()) - Mat3::Identity();
  state.stress = 2 * moduli.mu * strain;
  state.stress.diagonal().array() += moduli.lambda * strain.trace();
  state.energy_density = 0.5 * state.stress.cwiseProduct(strain).sum();
  state.inverted = !(gradient.determinant() > 0);
  return state;
}

}  // namespace griffith
