#pragma once

#include <array>

#include "sim/elasticity/element.h"
#include "sim/elasticity/plasticity.h"

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

/// Values of a tensor at the corners of a tet, or at its integration points; that nearest to a corner has its index.
using CornerTensors = std::array<Mat3, 4>;
/// Returns the same value at all corners.
inline CornerTensors at_all_corners(const Mat3& value) { return {value, value, value, value}; }
/// Returns the values of a linear field at the integration points from those at the corners, and the reverse.
CornerTensors at_integration_points(const CornerTensors& at_corners);
CornerTensors at_corners(const CornerTensors& at_integration_points);

/// Returns F_v of the four corners.
std::array<Mat3, 4> corner_gradients(const RestElement& rest, const Corners& corners, const EdgeVectors& offsets);

/// Strains of the corners; all in the frame of F_0, except with Green's strain [-].
struct CornerStrains {
  CornerTensors corners;
  bool inverted = false;  ///< det F_0 <= 0
};
CornerStrains corner_strains(ElementModel model, const RestElement& rest, const Corners& corners,
                             const EdgeVectors& offsets);

/// Returns the plastic strains of the integration points after flow().
CornerTensors flow(const PlasticLaw& law, const CornerStrains& strains, const CornerTensors& plastic_strains);

/// Stressed state of a quadratic tetrahedron. Corotational corners share the rotation of F_0. With Green's strain each
/// has its own frame F_v, unless F_0 is inverted.
struct QuadraticState {
  std::array<ElementState, 4> corners;  ///< states of the material there, which does not exceed its yield strength
  /// P in the forces −P g_i on corners i, world frame [N·m]: Σ_v B_v s_v with s_v = V/20 (σ_v + Σ σ), plus the
  /// contribution of the rotating corotational frame. The forces are therefore the energy's derivative and have no
  /// torque.
  Mat3 corner_traction = Mat3::Zero();
  EdgeVectors edge_forces = EdgeVectors::Zero();  ///< [N]
};

/// State and its mean over the tet, with the mean stress, the frame of F_0 and the energy density of the whole.
struct QuadraticStates {
  QuadraticState state;
  ElementState mean;
  Mat3 mean_cauchy_stress;  ///< world frame [Pa]
};
/// `stress_free`: strains without stress at the corners [-]. The linear field of a stress that is limited at the
/// integration points exceeds the yield strength at corners. With a `plastic` law the states of corners are those of
/// material that has flowed there as well; forces and the mean are not affected.
QuadraticStates quadratic_states(const ElasticLaw& law, const RestElement& rest, const Corners& corners,
                                 const EdgeVectors& offsets,
                                 const CornerTensors& stress_free = at_all_corners(Mat3::Zero()),
                                 const std::optional<PlasticLaw>& plastic = {});

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
