#pragma once

#include <span>
#include <vector>

#include "sim/core/linear_algebra.h"
#include "sim/core/point_compliance.h"
#include "sim/solver/block_sparse_matrix.h"
#include "sim/solver/factor_preconditioner.h"
#include "sim/solver/preconditioner.h"

namespace griffith {

/// The motions of a deformable body as a whole that nothing resists but its mass: all of a free one, turns about a
/// pivot of one that supports hold there. Their momentum balances exactly, whatever stress does in the linearized A.
struct WholeMotion {
  NodeVectors arms = {};                ///< of nodes from the center of mass or the pivot, then offsets of edges [m]
  Eigen::VectorXd masses = {};          ///< of the nodes [kg]
  double inverse_mass = 0;              ///< 0 at a pivot [1/kg]
  Mat3 inverse_inertia = Mat3::Zero();  ///< 0 across the axes of a pivot [1/(kg·m²)]
  double damping = 1;                   ///< 1 + h·alpha, by which mass resists in an implicit step
  bool exists() const { return arms.cols() > 0; }
  Vec3 spin_of(const Eigen::Ref<const NodeVectors>& velocities) const;
  /// The motion as a whole that has the momentum of these velocities: Q v.
  NodeVectors part_of(const Eigen::Ref<const NodeVectors>& velocities) const;
  /// The momentum by which these impulses move the whole: Qᵀ p.
  NodeVectors momentum_of(const Eigen::Ref<const NodeVectors>& impulses) const;
};

/// A deformable body of a contact problem: what resists changes of the velocities of its rows [kg].
struct DeformableInertia {
  const BlockSparseMatrix* matrix = nullptr;                ///< A of an implicit step; null: `masses` alone
  const RigidModePreconditioner* preconditioner = nullptr;  ///< of `matrix`
  Eigen::VectorXd masses = {};                              ///< per row, of an explicit step [kg]
  WholeMotion whole = {};
  const FactorPreconditioner* factors = nullptr;  ///< of `matrix`, where there are any
  int rows() const { return matrix ? matrix->rows() : static_cast<int>(masses.size()); }
};

/// A free rigid body of a contact problem.
struct RigidInertia {
  double mass = 1;                  ///< [kg], > 0
  Mat3 inertia = Mat3::Identity();  ///< about the centre of mass, world frame [kg·m²]
};

/// One side of a contact. It does not move under impulses where `body` is -1.
struct ContactSide {
  int body = -1;               ///< index into the deformable or the rigid bodies
  bool deformable = false;     ///< which of the two
  WeightedRows point = {};     ///< of a deformable body: of its surface
  Vec3 offset = Vec3::Zero();  ///< from there to the contact, which turns with the body as a whole [m]
  Vec3 arm = Vec3::Zero();     ///< of a rigid body, from its centre of mass [m]
};

/// A contact with friction. Vectors are along `axes`: the normal from b to a, and two tangents.
struct FrictionContact {
  ContactSide a, b;
  Mat3 axes = Mat3::Identity();       ///< columns
  double friction = 0;                ///< Coulomb's coefficient, >= 0
  double target_velocity = 0;         ///< least velocity of parting [m/s]
  Vec3 free_velocity = Vec3::Zero();  ///< of a relative to b without impulses [m/s]
  Vec3 impulse = Vec3::Zero();        ///< on a: a guess before, the solution after [N·s]
};

/// Work and outcome of a solve.
struct ContactSolveReport {
  int newton_steps = 0, iterations = 0;
  int unconverged = 0;  ///< contacts whose law is not met within the tolerance
};

/// Accuracy of a solve.
struct ContactTolerance {
  double relative = 1e-4;          ///< of the largest change of velocity that contacts have to make
  double negligible_speed = 1e-9;  ///< [m/s]
  int max_rounds = 20, max_newton_steps = 60, max_iterations = 400;
};

/// Impulses and velocities of bodies in frictional contact (Signorini and Coulomb) at the end of an implicit step.
///
/// With v* the velocities without contact, y = v − v*, u = u* + J y the relative velocities at the contacts and g their
/// targets, y minimizes the strictly convex
///   ½ yᵀ A y + Σ r/2 |γ(u)|²,   γ(u) = project_on_cone(γ₀ + (g − µ|u_t| n − u) / r, µ)
/// whose stationary point is A y = Jᵀ γ (Todorov 2014; Castro, Permenter & Han 2022). Newton's method with an exact
/// line search finds it; conjugate gradients solve its linear systems. γ₀ and the sliding speed |u_t| are those of the
/// round before: rounds make the contacts rigid however soft r is (augmented Lagrangian: Alart & Curnier 1991), and
/// keep what slides from lifting off (de Saxcé & Feng 1998; Cadoux's fixed point, Acary et al. 2011).
/// Writes the impulses of `contacts`, and `changes` y of the deformable bodies, one column a row [m/s]. The same bits
/// for any number of threads.
ContactSolveReport solve_contact_problem(std::span<const DeformableInertia> deformable,
                                         std::span<const RigidInertia> rigid, std::span<FrictionContact> contacts,
                                         const ContactTolerance& tolerance, std::vector<NodeVectors>& changes);

/// Change of the velocities of a body by impulses on its rows alone [N·s]; the momentum of the whole is exact. The rest
/// stops at a residual of `relative_residual`.
NodeVectors respond_alone(const DeformableInertia& body, const NodeVectors& impulses, double relative_residual,
                          int max_iterations);

}  // namespace griffith
