#pragma once

#include <array>

#include "sim/elasticity/element.h"

// Tetrahedra whose displacements are quadratic, in a hierarchical basis: a point with barycentric coordinates L is at
//   x = Σ L_i x_i + Σ 4 L_i L_j w_ij,
// x_i the places of the corners and w_ij the offsets of the edges: how far an edge's middle is from the middle of its
// ends. Without offsets it is the linear tetrahedron. The deformation gradient is linear, F_v at corner v:
//   F_v = F_0 + 4 Σ_j w_vj g_jᵀ,   F_0 that of the corners alone.
// Stress is taken as linear too, so that its values at the corners tell all.

namespace griffith {

/// Values at the six edges of a tet: one column an edge, as kTetEdges has them.
using EdgeVectors = Eigen::Matrix<double, 3, 6, Eigen::DontAlign>;

/// F_v of the four corners.
std::array<Mat3, 4> corner_gradients(const RestElement& rest, const Corners& corners, const EdgeVectors& offsets);

/// The stressed state of a quadratic tetrahedron. Corotational corners share the rotation of F_0; with Green's strain
/// each has its own frame F_v, unless F_0 is inverted.
struct QuadraticState {
  std::array<ElementState, 4> corners;
  /// What acts with −P g_i on corner i, world frame [N·m]: Σ_v B_v s_v, s_v = V/20 (σ_v + Σ σ), and what the
  /// turning of the corotational frame adds, so that the forces are the energy's derivative and have no torque.
  Mat3 corner_traction = Mat3::Zero();
};

/// A state and the mean of it over the tet, whose stress is the mean one, whose frame is that of F_0 and whose energy
/// density is that of the whole.
struct QuadraticStates {
  QuadraticState state;
  ElementState mean;
  Mat3 mean_cauchy_stress;  ///< world frame [Pa]
};
QuadraticStates quadratic_states(const ElasticLaw& law, const RestElement& rest, const Corners& corners,
                                 const EdgeVectors& offsets, const Mat3& plastic_strain = Mat3::Zero());

/// Forces on the corners and edges of a tet [N]: −∂E/∂x_i and −∂E/∂w_ij of E = V/40 (Σ σ_v : ε_v + Σ σ_v : Σ ε_v).
struct QuadraticForces {
  Corners corners;
  EdgeVectors edges;
};
QuadraticForces quadratic_forces(const RestElement& rest, const QuadraticState& state);
/// Rayleigh's damping by the stiffness per beta, −K v [N/s]: the forces of the stress rates, in the frame B of the
/// mean.
QuadraticForces quadratic_damping_forces(const ElasticLaw& law, const RestElement& rest, const Mat3& frame,
                                         const Corners& velocities, const EdgeVectors& of_edges);

}  // namespace griffith
