#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "sim/solver/block_cholesky.h"
#include "sim/solver/coarse_reduction.h"
#include "sim/solver/contact_jacobian.h"
#include "sim/solver/contact_motion.h"

namespace griffith {

/// Solves with an approximation of A + Jᵀ G J, the matrix of deformable and rigid bodies that stiff contacts join.
///
/// RigidModePreconditioner approximates the inverse of A by D⁻¹ + R (Rᵀ A R)⁻¹ Rᵀ, the inverse in the space of local
/// displacements y and rigid motions c of aggregates, v = y + R c, under the energy yᵀ D y + cᵀ Rᵀ A R c. Here the
/// contacts act in that space: its matrix
///   diag(D, Rᵀ A R) + Πᵀ Jᵀ G J Π,   Π (y, c) = y + R c
/// is factored without the nodes that nothing touches, whose y follows alone, and, where they are few, with the
/// aggregates alone that contacts touch (CoarseReduction). The number of iterations so depends on
/// the stiffness of the contacts as little as on that of the bodies (fictitious space lemma: Nepomnyaschikh 1991).
/// Condensed bodies (TouchedInverse) take part with all of their unknowns, bodies that have factors with all of their
/// rows and A. Rigid bodies are aggregates without local displacements, solved exactly.
class ContactPreconditioner {
 public:
  /// `bodies`: those of `deformable` and `rigid` in one vector; all stay.
  ContactPreconditioner(const ContactBodies& bodies, std::span<const DeformableInertia> deformable,
                        std::span<const RigidInertia> rigid, std::span<const FrictionContact> contacts);

  /// Takes G, one symmetric positive semidefinite block a contact, along its axes [kg]. False where the matrix could
  /// not be factored.
  bool factor(const std::vector<Mat3>& stiffness);
  /// z = (approximately) (A + Jᵀ G J)⁻¹ r; after factor().
  void apply(const Eigen::VectorXd& r, Eigen::VectorXd& z) const;

 private:
  /// Unknowns of a deformable body: touched rows first, then six for each aggregate that is not eliminated.
  struct BodyUnknowns {
    std::vector<int> touched;                  ///< rows that take part, ascending
    std::optional<CoarseReduction> reduction;  ///< none without a coarse space
    const TouchedInverse* condensed = nullptr;
    bool has_all_rows = false;  ///< all take part, joined by the body's matrix
    int first_touched = 0, first_aggregate = 0;
    int offset = 0;  ///< in the vector of all bodies
    int row_unknown(int row) const;
  };
  void reduce_coarse_space(std::size_t body);
  void number_unknowns();
  void build_jacobian(std::span<const FrictionContact> contacts);
  void add_side(const ContactSide& side, const Mat3& axes);
  void build_pattern();
  void add_inertia();
  void find_slots();
  Eigen::VectorXd solve(const Eigen::VectorXd& reduced) const;

  std::span<const DeformableInertia> deformable_;
  std::span<const RigidInertia> rigid_;
  std::vector<BodyUnknowns> bodies_;
  int first_rigid_ = 0, rigid_offset_ = 0, unknowns_ = 0;
  ContactJacobian jacobian_;              // J Π
  BlockSparseMatrix matrix_;              // of the unknowns, three a row
  std::vector<Mat3> inertia_;             // blocks of matrix_ without contacts
  std::vector<int> slots_;                // of matrix_: per contact and pair of its 3×3 blocks
  std::vector<std::size_t> slot_starts_;  // per contact
  std::shared_ptr<const EliminationPlan> plan_;
  std::optional<BlockCholesky> factors_;
  BlockCholesky::Workspace space_;
};

}  // namespace griffith
