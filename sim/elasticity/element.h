#pragma once

#include <array>

#include "sim/elasticity/material.h"
#include "sim/linear_algebra.h"

namespace griffith {

/// Corner positions, forces or gradients of a tet: one column a corner.
using Corners = Eigen::Matrix<double, 3, 4>;

/// The constant part of a linear tetrahedron.
struct ElementRest {
  Corners shape_gradients;  ///< column i: g_i = grad N_i in rest space [1/m]
  double volume = 0;        ///< V at rest [m³], > 0
};

/// Rest data of a positively oriented tet with these corners [m].
ElementRest element_rest(const Corners& rest_corners);

/// Lamé's constants of an element.
struct ElasticModuli {
  double lambda = 0, mu = 0;  ///< [Pa]
};
ElasticModuli elastic_moduli(const Material& material);

/// F = sum_i x_i g_iᵀ.
inline Mat3 deformation_gradient(const ElementRest& rest, const Corners& corners) {
  return corners * rest.shape_gradients.transpose();
}

/// The state of a corotated linear element (Müller & Gross 2004).
struct ElementState {
  Mat3 rotation = Mat3::Identity();  ///< Q of F = Q A
  Mat3 stress = Mat3::Zero();        ///< Cauchy stress sigma in the corotated frame [Pa]
  double energy_density = 0;         ///< ½ sigma : epsilon [J/m³]
  bool inverted = false;             ///< det F <= 0
};

/// epsilon = sym(QᵀF) − I, sigma = lambda tr(epsilon) I + 2 mu epsilon.
ElementState corotational_state(const ElementRest& rest, const ElasticModuli& moduli, const Corners& corners);

/// Nodal forces of a stress given in the corotated frame, in the world frame: f_i = −V Q sigma g_i [N].
inline Corners nodal_forces(const ElementRest& rest, const Mat3& rotation, const Mat3& stress) {
  return -rest.volume * (rotation * stress) * rest.shape_gradients;
}

/// The stiffness block between two corners with rotated gradients a = Q g_i, b = Q g_j, without the volume:
/// lambda a bᵀ + mu b aᵀ + mu (a·b) I. Symmetric positive semidefinite as a whole; it leaves out the change of Q.
inline Mat3 stiffness_block(const ElasticModuli& moduli, const Vec3& a, const Vec3& b) {
  Mat3 block = moduli.lambda * a * b.transpose() + moduli.mu * b * a.transpose();
  block.diagonal().array() += moduli.mu * a.dot(b);
  return block;
}

}  // namespace griffith
