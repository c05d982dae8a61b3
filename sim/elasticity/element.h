#pragma once

#include <span>

#include "sim/core/ids.h"
#include "sim/core/linear_algebra.h"
#include "sim/elasticity/material.h"

namespace griffith {

/// Corner positions, forces or gradients of a tet: one column per corner.
using Corners = Eigen::Matrix<double, 3, 4, Eigen::DontAlign>;

/// Constant data of a linear tetrahedron.
struct RestElement {
  Corners shape_gradients;  ///< column i: g_i = grad N_i in rest space [1/m]
  double volume = 0;        ///< V at rest [m³], > 0
};

/// Returns the rest data of a positively oriented tet with these corners [m].
RestElement rest_element(const Corners& rest_corners);

/// Returns the edge length of the cubes that six of these elements fill on average [m]; 0 for none.
double mean_element_size(std::span<const RestElement> elements);
/// Returns the mean size of some elements of a mesh.
double mean_element_size(std::span<const RestElement> elements, std::span<const TetId> tets);

/// Constitutive law of an element: its strain measure, and Lamé's constants.
struct ElasticLaw {
  ElementModel model = ElementModel::corotational;
  double lambda = 0, mu = 0;  ///< [Pa]
  double compaction = 0;      ///< modulus against loss of volume (compaction.h) [Pa]; 0: not resisted

  bool operator==(const ElasticLaw&) const = default;
};
ElasticLaw elastic_law(const Material& material);

/// Returns F = sum_i x_i g_iᵀ.
Mat3 deformation_gradient(const RestElement& rest, const Corners& corners);

/// Strain in rest space of a deformation gradient F, and the frame B that maps rest space to the world. The strain's
/// stress acts with the forces f_i = −V B sigma g_i.
///   corotational   B = Q of the polar decomposition F = Q A,   epsilon = sym(QᵀF) − I   (Müller & Gross 2004)
///   green_strain   B = F,                                      epsilon = ½ (FᵀF − I)     (O'Brien & Hodgins 1999)
/// Green's strain cannot distinguish an element from its mirror image. An inverted element therefore uses the
/// corotational row, whose forces turn it back.
struct ElementDeformation {
  Mat3 frame = Mat3::Identity();
  Mat3 strain = Mat3::Zero();
  bool inverted = false;  ///< det F <= 0
};
ElementDeformation element_deformation(ElementModel model, const RestElement& rest, const Corners& corners);

/// Stressed state of an element. Stresses are in rest space: corotated Cauchy stress, or the second Piola-Kirchhoff
/// stress for Green's strain [Pa].
struct ElementState {
  Mat3 frame = Mat3::Identity();  ///< B
  SymmetricMat3 stress;
  Mat3 tensile_traction = Mat3::Zero();  ///< B sigma⁺ with the tensile_part() sigma⁺ of the stress [Pa]
  SymmetricMat3 tension;                 ///< tensile part as Cauchy stress in the world frame [Pa]
  double tension_norm = 0;               ///< Frobenius norm of `tension` [Pa]
  SymmetricMat3 compaction;              ///< Compaction::gradient [√Pa]
  double energy_density = 0;             ///< ½ sigma : epsilon per rest volume, and that of compaction [J/m³]
  bool inverted = false;

  bool is_compacted() const { return compaction.xx != 0; }
};

/// Returns the state of sigma = lambda tr(epsilon_e) I + 2 mu epsilon_e for the elastic strain epsilon_e = epsilon −
/// `plastic_strain`.
ElementState element_state(const ElasticLaw& law, const ElementDeformation& deformation,
                           const Mat3& plastic_strain = Mat3::Zero());

/// Returns the traction that the dependence of the rotation Q on F = Q S adds to that of the stress. With δQ = Q Ω, the
/// energy changes by Q Z : δF, Z the skew matrix of (tr(S) I − S)⁻¹ axial(`moments`), `moments` = S sigma; in its unit.
/// Zero where stress and S have the same axes, as without stress-free strains, and in flat elements, where Q jumps.
Mat3 turning_traction(const Mat3& rotation, const Mat3& gradient, const Mat3& moments);
/// Returns that of an element with this state [Pa]; zero if the frame of its model is no rotation.
Mat3 turning_traction(ElementModel model, const RestElement& rest, const Corners& corners, const ElementState& state);

/// Returns a stress of rest space as Cauchy stress in the world frame, B sigma Bᵀ / det B [Pa]. The volume ratio counts
/// as at least 0.01, so that a flat element's stress stays finite.
Mat3 cauchy_stress(const Mat3& frame, const Mat3& stress);

/// Returns the nodal forces of a stress of rest space in the world frame: f_i = −V B sigma g_i [N].
Corners nodal_forces(const RestElement& rest, const Mat3& frame, const Mat3& stress);

}  // namespace griffith
