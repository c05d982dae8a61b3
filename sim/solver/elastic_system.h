#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "sim/elasticity/element.h"
#include "sim/mesh/tet_mesh.h"
#include "sim/solver/conjugate_gradient.h"

namespace griffith {

/// What an implicit step is made with.
struct ImplicitStep {
  double dt = 0;                 ///< h [s], > 0
  double mass_damping = 0;       ///< Rayleigh's alpha [1/s]
  double stiffness_damping = 0;  ///< Rayleigh's beta [s]
  double relative_residual = 1e-4;
  int max_iterations = 400;
};

/// The linear system of one connected body: the linearised implicit step (Baraff & Witkin 1998)
///   (M + hC + h²K) v⁺ = M v + h (f_elastic + f_external),   C = alpha M + beta K.
/// Its pattern and aggregates stand as long as the body's topology does.
class ElasticSystem {
 public:
  /// `tets`: the body's; `held`: per node of the mesh, 1 where a support holds it. Writes the row of each of the body's
  /// nodes to `row_of_node` (per node of the mesh), -1 for held ones.
  ElasticSystem(const TetMesh& mesh, std::span<const TetId> tets, std::span<const std::uint8_t> held,
                std::span<int> row_of_node);

  /// The body's free nodes, ascending; row i of the system is nodes()[i].
  std::span<const NodeId> nodes() const { return nodes_; }
  /// Whether no node is held, so that the body's rigid motion follows from the forces alone.
  bool is_free() const { return held_count_ == 0; }

  /// Builds M + hC + h²K and its preconditioner for the present rotations and positions. Spans are per node or tet of
  /// the mesh; all tets of a body share `moduli`.
  void assemble(const ImplicitStep& step, const ElasticModuli& moduli, std::span<const ElementRest> rests,
                std::span<const ElementState> states, std::span<const Vec3> positions, std::span<const double> masses);

  /// Replaces the velocities of the free nodes by v⁺ under `forces` (elastic plus external, per node of the mesh [N]).
  /// The linear and angular momentum of a free body are exact, whatever residual is left; it is solved in axes that turn
  /// with it, so its owner moves it by turning (turn_step() in rigid_motion.h), not along tangents.
  SolveReport solve(const ImplicitStep& step, std::span<const Vec3> positions, std::span<const Vec3> forces,
                    std::span<const double> masses, std::span<Vec3> velocities) const;

  /// How far a free node would go under a unit impulse, its neighbours standing still [1/kg]; after assemble().
  const Mat3& inverse_diagonal(int row) const { return preconditioner_->inverse_diagonal(row); }
  const BlockSparseMatrix& matrix() const { return matrix_; }

 private:
  struct RowEntry {  // a tet at a node: where its four blocks of the row go, -1 for held corners
    TetId tet;
    int corner;
    std::array<int, 4> slots;
  };
  void build_pattern(const TetMesh& mesh, std::span<const int> row_of_node);
  SolveReport solve_free(const ImplicitStep& step, const NodeVectors& positions, const Eigen::VectorXd& masses,
                         const NodeVectors& b, NodeVectors& x) const;
  NodeVectors gather(std::span<const Vec3> values) const;

  std::vector<NodeId> nodes_;
  int held_count_ = 0;
  std::vector<int> entry_starts_;  // per row, into entries_
  std::vector<RowEntry> entries_;
  BlockSparseMatrix matrix_;
  std::unique_ptr<RigidModePreconditioner> preconditioner_;
};

}  // namespace griffith
