#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "sim/elasticity/quadratic_element.h"
#include "sim/solver/elastic_system.h"

namespace griffith {

/// The edges of a quadratic body. Spans are per edge of the mesh.
struct StaticEdges {
  const TetEdges& topology;
  std::span<Vec3> offsets;                 ///< the start and the answer [m]
  std::span<const QuadraticState> states;  ///< per tet, as `evaluate` leaves them
  std::span<const Vec3> loads = {};        ///< as StaticProblem::loads [N]; empty: none
};

/// A body at rest under loads. Spans are per node or tet of the mesh and outlive the problem.
struct StaticProblem {
  const TetMesh& mesh;
  std::span<const TetId> tets;  ///< the body's, ascending
  std::span<const RestElement> rest_elements;
  ElasticLaw law;
  std::span<const double> masses;  ///< [kg]
  /// What supports block; the known velocities count as displacements to make [m].
  std::span<const NodeConstraint> constraints;
  std::span<const Vec3> loads;  ///< that stay the same wherever the nodes go [N]
  /// Sets the states of the body's tets for these positions, per node and tet of the mesh.
  std::function<void(std::span<const Vec3> positions, std::span<ElementState> states)> evaluate;
  /// Adds the loads that follow the nodes, such as pressures, at these positions, per node and edge of the mesh [N];
  /// empty: none.
  std::function<void(std::span<const Vec3> positions, std::span<Vec3> loads, std::span<Vec3> of_edges)>
      add_follower_loads = {};
  /// True if linear tets have stress-free strains: their forces include turning_traction().
  bool has_stress_free_strains = false;
  /// Edges of a quadratic body: `evaluate` sets their states for their offsets, and the mean states.
  std::optional<StaticEdges> edges = {};
};

struct StaticSettings {
  double relative_residual = 1e-10;
  int max_newton_steps = 60;
  int max_iterations = 1000;  ///< limit of conjugate gradients per Newton step, 20 times as many for large quadratic
                              ///< bodies; then a sparse factorization takes over
  std::function<bool()> cancelled = {};  ///< called often; true ends the solve early
};

struct StaticReport {
  int newton_steps = 0;
  int linear_iterations = 0;
  int factorizations = 0;        ///< Newton steps that conjugate gradients did not finish
  double relative_residual = 0;  ///< |unbalanced nodal forces| / |loads and reactions|
  bool converged = false;        ///< to the residual that was asked for, or to what rounding leaves
  /// Rigid motions that no support blocks, 0..6. Along them the solution is the one with inertia relief: the body
  /// accelerates as a whole, and its own inertia balances the loads.
  int free_motions = 0;
  double unbalanced_fraction = 0;     ///< fraction of the loads that accelerates the body; 0 in true equilibrium
  std::vector<NodeId> supports;       ///< constrained nodes, ascending
  std::vector<Vec3> reaction_forces;  ///< per support: the force on the node in its blocked directions [N]
};

/// Static equilibrium f_elastic(x) + loads(x) = 0 by Newton's method with a line search on the potential energy. The
/// derivative of loads that follow the nodes is left out of the matrix: with such it converges linearly. Where supports
/// stand still and the start is in balance to the residual that is asked for, nothing moves.
/// `positions` [m] hold the start and the answer, `states` the elements' at the answer; both per node or tet of the
/// mesh, the body's alone are written.
StaticReport solve_static(const StaticProblem& problem, const StaticSettings& settings, std::span<Vec3> positions,
                          std::span<ElementState> states);

}  // namespace griffith
