#include "sim/elasticity/element.h"

#include <Eigen/LU>
#include <cassert>
#include <cmath>

#include "sim/elasticity/element_kernel.h"

namespace griffith {
namespace {

/// Returns ε_kij m_ij, up to the sign twice the axial vector of the skew part.
Vec3 axial(const Mat3& m) { return {m(1, 2) - m(2, 1), m(2, 0) - m(0, 2), m(0, 1) - m(1, 0)}; }

/// Returns the matrix Z with z·axial(m) = Z : m for all m.
Mat3 skew(const Vec3& z) {
  Mat3 m;
  m << 0, z[2], -z[1], -z[2], 0, z[0], z[1], -z[0], 0;
  return m;
}

double size_of(double volume, std::size_t count) {
  return count == 0 ? 0 : std::cbrt(6 * volume / static_cast<double>(count));
}

}  // namespace

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

double mean_element_size(std::span<const RestElement> elements) {
  double volume = 0;
  for (const RestElement& element : elements) volume += element.volume;
  return size_of(volume, elements.size());
}

double mean_element_size(std::span<const RestElement> elements, std::span<const TetId> tets) {
  double volume = 0;
  for (const TetId tet : tets) volume += elements[tet].volume;
  return size_of(volume, tets.size());
}

ElasticLaw elastic_law(const Material& material) {
  return {material.element_model, lame_lambda(material), shear_modulus(material)};
}

Mat3 deformation_gradient(const RestElement& rest, const Corners& corners) {
  return corners * rest.shape_gradients.transpose();
}

ElementDeformation element_deformation(ElementModel model, const RestElement& rest, const Corners& corners) {
  return simd::deformation_of(model, simd::gradient_of<double>(corners, rest.shape_gradients)).of(0);
}

ElementState element_state(const ElasticLaw& law, const ElementDeformation& deformation, const Mat3& plastic_strain) {
  const simd::Deformation<double> one{simd::numbers(deformation.frame), simd::upper_triangle(deformation.strain),
                                      deformation.inverted};
  return simd::state_of(law, one, simd::upper_triangle(plastic_strain)).of(0);
}

Mat3 turning_traction(const Mat3& rotation, const Mat3& gradient, const Mat3& moments) {
  const Mat3 stretch = rotation.transpose() * gradient;
  const Mat3 turning = stretch.trace() * Mat3::Identity() - stretch;
  const Vec3 z = turning.inverse() * axial(moments);
  return z.allFinite() ? Mat3(rotation * skew(z)) : Mat3(Mat3::Zero());
}

Mat3 turning_traction(ElementModel model, const RestElement& rest, const Corners& corners, const ElementState& state) {
  if (model != ElementModel::corotational && !state.inverted) return Mat3::Zero();
  const Mat3 gradient = deformation_gradient(rest, corners);
  return turning_traction(state.frame, gradient, state.frame.transpose() * gradient * state.stress.full());
}

Mat3 cauchy_stress(const Mat3& frame, const Mat3& stress) {
  const simd::Matrix3<double> b = simd::numbers(frame);
  return simd::pushed_forward(b * simd::upper_triangle(stress), b, simd::determinant(b, simd::cofactor(b))).of(0);
}

Corners nodal_forces(const RestElement& rest, const Mat3& frame, const Mat3& stress) {
  return -rest.volume * (frame * stress) * rest.shape_gradients;
}

}  // namespace griffith
