#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "sim/core/copy_on_write.h"
#include "sim/solver/assembly_inputs.h"
#include "sim/solver/conjugate_gradient.h"
#include "sim/solver/element_rows.h"
#include "sim/solver/node_constraint.h"

namespace griffith {

/// Parameters of an implicit step.
struct ImplicitStep {
  double dt = 0;                 ///< h [s], > 0
  double mass_damping = 0;       ///< Rayleigh's alpha [1/s]
  double stiffness_damping = 0;  ///< Rayleigh's beta [s]
  double relative_residual = 1e-4;
  int max_iterations = 400;
};

/// Returns the factors of mass and stiffness in A.
inline MatrixFactors matrix_factors(const ImplicitStep& step) {
  return {1 + step.dt * step.mass_damping, step.dt * (step.dt + step.stiffness_damping)};
}

/// The edges of quadratic bodies, per edge of the mesh; empty for a linear body.
struct EdgeMotion {
  std::span<const Vec3> offsets;   ///< [m]
  std::span<const Vec3> forces;    ///< [N]
  std::span<const double> masses;  ///< [kg]
  std::span<Vec3> velocities;      ///< velocities of the offsets [m/s]
};

/// Linear system of one connected body: the linearized implicit step (Baraff & Witkin 1998)
///   A v⁺ = b,   A = M + hC + h²K,   b = M v + h (f_elastic + f_external),   C = alpha M + beta K,
/// under the constraints of its nodes. With S the projector onto the allowed velocities (NodeConstraint::allowed, one
/// block per node) and w the known velocities, v⁺ = w + x where
///   S A S x = S (b − A w).
/// Held nodes have no row. In the row of a sliding one, the scaled I − S keeps the matrix positive definite. The
/// pattern and the aggregates remain valid as long as the body's topology does, and are patched where it changes. Edges
/// of a quadratic body have rows after those of the nodes, under the constraints common to both of their ends.
class ElasticSystem {
 public:
  /// `tets`: the body's; `constraints`: per node of the mesh. Writes the row of each of the body's nodes to
  /// `row_of_node` (per node of the mesh), -1 for held ones.
  ElasticSystem(const TetMesh& mesh, std::span<const TetId> tets, std::span<const NodeConstraint> constraints,
                std::span<int> row_of_node);
  /// System of a quadratic body. Also writes the rows of its edges (per edge of the mesh), which are constrained by the
  /// constraints `of_ends` (per node of the mesh) of both ends.
  ElasticSystem(const TetMesh& mesh, const TetEdges& topology, std::span<const TetId> tets,
                std::span<const NodeConstraint> constraints, std::span<const NodeConstraint> of_ends,
                std::span<int> row_of_node, std::span<int> row_of_edge);

  /// Fits the system of a linear body to cracks and lost pieces: `body_nodes` are all its present nodes, ascending.
  /// Tets may have left it, and nodes may have been copied (split_node() in split.h); the constraints of old nodes
  /// block the same directions as before. Only the rows around the cracks are rebuilt; assemble() is to follow. The
  /// result is that of construction except for the aggregates, which remain where they are still connected. Writes
  /// `row_of_node` as the constructor does.
  void patch(const TetMesh& mesh, std::span<const NodeId> body_nodes, std::span<const NodeConstraint> constraints,
             std::span<int> row_of_node);

  /// Returns the body's nodes that are not held, ascending; row i of the system is nodes()[i].
  std::span<const NodeId> nodes() const { return rows_->nodes; }
  /// Returns the edges of a quadratic body that are not held, ascending; their rows come after those of the nodes.
  std::span<const EdgeId> edges() const { return rows_->edges; }
  int rows() const { return matrix().rows(); }
  /// Returns the body's constrained nodes, ascending.
  std::span<const NodeId> supports() const { return support_rows_->nodes; }
  /// True if no node is constrained, so that the body's rigid motion follows from the forces alone.
  bool is_free() const { return supports().empty(); }

  /// Builds the matrix and its preconditioner for the present states and positions, or keeps them where they would come
  /// out the same (AssemblyInputs::still_hold()). Spans are per node or tet of the mesh; all tets of a body share
  /// `law`.
  void assemble(const ImplicitStep& step, const ElasticLaw& law, std::span<const RestElement> rest_elements,
                std::span<const ElementState> states, std::span<const Vec3> positions, std::span<const double> masses,
                std::span<const double> edge_masses = {});

  /// Assembles any combination of mass and stiffness, for solve_projected().
  void assemble(const MatrixFactors& factors, const ElasticLaw& law, std::span<const RestElement> rest_elements,
                std::span<const ElementState> states, std::span<const Vec3> positions, std::span<const double> masses,
                std::span<const double> edge_masses = {});

  /// Assembles the step of a linear body with the second derivatives of its energy, per tet of the mesh.
  void assemble(const ImplicitStep& step, std::span<const RestElement> rest_elements,
                std::span<const TangentStiffness> tangents, std::span<const Vec3> positions,
                std::span<const double> masses);

  /// Replaces the velocities of the body's nodes by v⁺ under `forces` (elastic plus external, per node of the mesh
  /// [N]); after assemble(). `constraints` block the directions that they blocked at construction, at any speed. The
  /// linear and angular momentum of a free body are exact, whatever residual is left; it is solved in axes that turn
  /// with it, so its owner moves it by turning (free_turn()), not along tangents.
  SolveReport solve(const ImplicitStep& step, std::span<const Vec3> positions, std::span<const Vec3> forces,
                    std::span<const double> masses, std::span<const NodeConstraint> constraints,
                    std::span<Vec3> velocities, const EdgeMotion& edges = {});

  /// Solves S A S x = S (b − A w) for x = S x, w the known part of the constraints; one column a row. `x` holds a
  /// guess. `cancelled`: as in conjugate_gradient().
  SolveReport solve_projected(std::span<const NodeConstraint> constraints, double relative_residual, int max_iterations,
                              NodeVectors b, NodeVectors& x, const std::function<bool()>& cancelled = {});
  /// Solves it by a factorization; false when that breaks down, and `x` is left alone.
  bool solve_directly(std::span<const NodeConstraint> constraints, NodeVectors b, NodeVectors& x) const;
  /// Returns the values of nodes() and edges() out of values per node and per edge of the mesh, one column a row; zero
  /// for edges without values.
  NodeVectors gather(std::span<const Vec3> values, std::span<const Vec3> of_edges = {}) const;
  /// Returns the masses likewise, per row.
  Eigen::VectorXd gather_masses(std::span<const double> masses, std::span<const double> of_edges) const;

  /// Returns the reactions of the supports in the last solve(), per node of supports(): the force on the node in its
  /// blocked directions [N], from the balance of its momentum.
  std::span<const Vec3> reaction_forces() const { return reactions_; }

  /// Adds to `reactions` (per node of the mesh [N]) what supports do against `impulses` (likewise [N·s]) that come on
  /// top of the forces of the last solve() and change the velocities of the rows by `change`.
  void add_reactions(double dt, std::span<const Vec3> impulses, std::span<const NodeConstraint> constraints,
                     const NodeVectors& change, std::span<Vec3> reactions) const;
  /// Takes out of velocities, one column a row, what constraints block.
  void project(NodeVectors& x) const;
  const BlockSparseMatrix& matrix() const { return rows_->matrix; }
  /// Returns the preconditioner of matrix(), after assemble().
  const RigidModePreconditioner& preconditioner() const { return **preconditioner_; }
  /// Factors of matrix(), of a quadratic body whose are affordable, or null; after assemble().
  const FactorPreconditioner* factors() const { return factors_ ? &*factors_ : nullptr; }
  /// About what it takes, but for what it shares with `beside` [bytes].
  std::size_t memory(const ElasticSystem* beside = nullptr) const;

 private:
  struct SlidingRow {
    int row;
    Mat3 allowed;
  };
  void rebuild_support_rows(const TetMesh& mesh, std::span<const NodeId> body_nodes,
                            std::span<const NodeConstraint> constraints, std::span<const int> row_of_node);
  void rebuild_support_rows(const TetMesh& mesh, const TetEdges& topology, std::span<const NodeId> body_nodes,
                            std::span<const NodeConstraint> constraints, std::span<const int> row_of_node,
                            std::span<const int> row_of_edge);
  void project_sliding_rows();
  /// b becomes S (b − A w), w less the translation `carried` [m/s].
  void project_right_hand_side(std::span<const NodeConstraint> constraints, NodeVectors& b,
                               const Vec3& carried = Vec3::Zero()) const;
  /// Solves for velocities beside the translation that the supports share; `masses`: one a row [kg].
  SolveReport solve_carried(const ImplicitStep& step, std::span<const NodeConstraint> constraints,
                            const Eigen::VectorXd& masses, NodeVectors b, NodeVectors& x) const;
  /// Solves S A S x = b, `b` projected, from the guess `x`.
  SolveReport solve_rows(const NodeVectors& b, NodeVectors& x, double relative_residual, int max_iterations,
                         const std::function<bool()>& cancelled = {}) const;
  /// Completes the impulses that reactions_ holds, −(M v + h f) of the supports, to reaction forces.
  void balance_supports(double dt, std::span<const NodeConstraint> constraints, std::span<const Vec3> velocities,
                        std::span<const Vec3> edge_velocities);
  Preconditioning preconditioning() const { return {preconditioner(), factors()}; }

  CopyOnWrite<ElementRows> rows_;  // S A S, one row a node that is not held
  // A, one row a constrained node; columns are nodes of the mesh, and edges of it from kFirstEdgeColumn on.
  CopyOnWrite<ElementRows> support_rows_;
  std::vector<SlidingRow> sliding_;
  std::vector<int> row_of_support_column_;             // per block of support_rows_, -1 for held nodes and edges
  std::vector<Vec3> reactions_;                        // of the last solve()
  std::optional<CopyOnWrite<AssemblyInputs>> inputs_;  // of the matrix; none since the rows changed
  std::optional<CopyOnWrite<RigidModePreconditioner>> preconditioner_;
  std::optional<FactorPreconditioner> factors_;  // in its stead
};

}  // namespace griffith
