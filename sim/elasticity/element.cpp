#include "sim/elasticity/element.h"

#include <Eigen/LU>
#include <algorithm>
#include <cassert>

#include "sim/elasticity/polar_decomposition.h"
#include "sim/elasticity/principal_stress.h"

namespace griffith {

RestElement rest_element(const Corners& rest_corners) {
  const Mat3 edges = rest_corners.rightCols<3>().colwise() - rest_corners.col(0);
  const double determinant = edges.determinant();
  assert(determinant > 0 && "meshes are oriented and checked before elements are made");
  const Mat3 inverse = edges.inverse();
  RestElement rest;
  rest.shape_gradients.rightCols<3>() = inverse.transpose();
  rest.shape_gradients.col(0) = -inverse.transpose().rowwise().sum();
  rest.volume = determinant / 6;
  return rest;
}

ElasticLaw elastic_law(const Material& material) {
  return {material.element_model, lame_lambda(material), shear_modulus(material)};
}

ElementDeformation element_deformation(ElementModel model, const RestElement& rest, const Corners& corners) {
  const Mat3 gradient = deformation_gradient(rest, corners);
  const bool inverted = !(gradient.determinant() > 0);
  if (model == ElementModel::green_strain && !inverted)
    return {gradient, 0.5 * (gradient.transpose() * gradient - Mat3::Identity()), false};
  const Mat3 rotation = polar_rotation(gradient);
  const Mat3 stretch = rotation.transpose() * gradient;
  return {rotation, 0.5 * (stretch + stretch.transpose()) - Mat3::Identity(), inverted};
}

ElementState element_state(const ElasticLaw& law, const ElementDeformation& deformation, const Mat3& plastic_strain) {
  const Mat3 strain = deformation.strain - plastic_strain;
  ElementState state;
  state.frame = deformation.frame;
  state.stress = 2 * law.mu * strain;
  state.stress.diagonal().array() += law.lambda * strain.trace();
  state.tensile_stress = tensile_part(state.stress);
  state.tension = cauchy_stress(state.frame, state.tensile_stress);
  state.tension_norm = state.tension.norm();
  state.energy_density = 0.5 * state.stress.cwiseProduct(strain).sum();
  state.inverted = deformation.inverted;
  return state;
}

Mat3 cauchy_stress(const Mat3& frame, const Mat3& stress) {
  constexpr double kSmallestVolumeRatio = 0.01;
  return frame * stress * frame.transpose() / std::max(frame.determinant(), kSmallestVolumeRatio);
}

namespace {

/// What in Green's model depends on the stretch: V [ mu (g_i·g_j) B Bᵀ + (g_iᵀ sigma⁺ g_j) I ].
void add_green_terms(const ElasticLaw& law, const RestElement& rest, const ElementState& state, int corner,
                     StiffnessRow& row) {
  const Mat3 metric = rest.volume * law.mu * state.frame * state.frame.transpose();
  const Vec3 gradient = rest.shape_gradients.col(corner), traction = rest.volume * state.tensile_stress * gradient;
  for (int j = 0; j < 4; ++j) {
    const Vec3 other = rest.shape_gradients.col(j);
    row.middleCols<3>(3 * j) += gradient.dot(other) * metric;
    row.middleCols<3>(3 * j).diagonal().array() += traction.dot(other);
  }
}

}  // namespace

StiffnessRow stiffness_row(const ElasticLaw& law, const RestElement& rest, const ElementState& state, int corner) {
  const Corners gradients = rest.volume * state.frame * rest.shape_gradients;
  const Vec3 a = state.frame * rest.shape_gradients.col(corner);
  StiffnessRow row;
  for (int j = 0; j < 4; ++j) {
    const Vec3 b = gradients.col(j), scaled = law.mu * b;
    row.middleCols<3>(3 * j) = law.lambda * a * b.transpose() + scaled * a.transpose();
    if (law.model == ElementModel::corotational) row.middleCols<3>(3 * j).diagonal().array() += a.dot(scaled);
  }
  if (law.model == ElementModel::green_strain) add_green_terms(law, rest, state, corner, row);
  return row;
}

}  // namespace griffith
