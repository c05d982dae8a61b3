#pragma once

#include <array>

#include "sim/elasticity/element.h"

// Tetrahedra with quadratic displacements in a hierarchical basis. A point with barycentric coordinates L is at
//   x = Σ L_i x_i + Σ 4 L_i L_j w_ij
// with the positions x_i of the corners and the offsets w_ij of the edges: the midpoint of an edge relative to the
// middle of its ends. Without offsets it is the linear tetrahedron. The deformation gradient is linear, F_v at corner
// v:
//   F_v = F_0 + 4 Σ_j w_vj g_jᵀ,   F_0 that of the corners alone.
// Stress is taken as linear too, so that its values at the corners determine it.

namespace griffith {

/// Values at the six edges of a tet: one column per edge, ordered as kTetEdges.
using EdgeVectors = Eigen::Matrix<double, 3, 6, Eigen::DontAlign>;

/// Returns F_v of the four corners.
std::array<Mat3, 4> corner_gradients(const RestElement& rest, const Corners& corners, const EdgeVectors& offsets);

/// Stressed state of a quadratic tetrahedron. Corotational corners share the rotation of F_0. With Green's strain each
/// has its own frame F_v, unless F_0 is inverted.
struct QuadraticState {
  std::array<ElementState, 4> corners;
  /// P in the forces −P g_i on corners i, world frame [N·m]: Σ_v B_v s_v with s_v = V/20 (σ_v + Σ σ), plus the
  /// contribution of the rotating corotational frame. The forces are therefore the energy's derivative and have no
  /// torque.
  Mat3 corner_traction = Mat3::Zero();
};

/// State and its mean over the tet, with the mean stress, the frame of F_0 and the energy density of the whole.
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
