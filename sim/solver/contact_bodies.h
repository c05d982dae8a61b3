#pragma once

#include <optional>

#include "sim/core/linear_algebra.h"
#include "sim/core/weighted_rows.h"
#include "sim/solver/block_sparse_matrix.h"
#include "sim/solver/preconditioner.h"
#include "sim/solver/whole_motion.h"

namespace griffith {

class FactorPreconditioner;

/// A deformable body of a contact problem: what resists changes of the velocities of its rows [kg].
struct DeformableInertia {
  const BlockSparseMatrix* matrix = nullptr;                ///< A of an implicit step; null: `masses` alone
  const RigidModePreconditioner* preconditioner = nullptr;  ///< preconditioner of `matrix`
  Eigen::VectorXd masses = {};                              ///< per row, of an explicit step [kg]
  WholeMotion whole = {};
  const FactorPreconditioner* factors = nullptr;  ///< factors of `matrix`, null if none
  bool factors_with_contacts = false;             ///< `matrix` is factored together with its contacts: its rows are few
  int rows() const { return matrix ? matrix->rows() : static_cast<int>(masses.size()); }
};

/// A free rigid body of a contact problem.
struct RigidInertia {
  double mass = 1;                  ///< [kg], > 0
  Mat3 inertia = Mat3::Identity();  ///< about the center of mass, world frame [kg·m²]
  bool operator==(const RigidInertia&) const = default;
};

/// One side of a contact. It does not move under impulses where `body` is -1.
struct ContactSide {
  int body = -1;               ///< index into the deformable or the rigid bodies
  bool deformable = false;     ///< which of the two
  WeightedRows point = {};     ///< point on the surface of a deformable body
  Vec3 offset = Vec3::Zero();  ///< offset of the contact from it, turning with the body as a whole [m]
  Vec3 arm = Vec3::Zero();     ///< offset of the contact from the center of mass of a rigid body [m]
  bool operator==(const ContactSide&) const = default;
};

/// Law of a bond, which resists that its sides come apart, in any direction, and nothing else.
struct Hold {
  Vec3 apart = Vec3::Zero();  ///< from b to a at the start, over the step [m/s]
  double slack = 0;           ///< distance up to which it does not act, over the step [m/s]
  double strength = 0;        ///< largest impulse [N·s]
  Vec3 given = Vec3::Zero();  ///< impulse that it has given in an earlier phase of the step [N·s]
  bool operator==(const Hold&) const = default;
};

/// A contact with friction, or a bond. Vectors are along `axes`: the normal from b to a, and two tangents.
struct FrictionContact {
  ContactSide a, b;
  Mat3 axes = Mat3::Identity();       ///< columns
  double friction = 0;                ///< Coulomb's coefficient, >= 0
  double target_velocity = 0;         ///< least velocity of parting [m/s]
  double rebound = 0;                 ///< speed of parting after an impact on nothing else [m/s], >= 0
  Vec3 free_velocity = Vec3::Zero();  ///< velocity of a relative to b without impulses [m/s]
  std::optional<Hold> hold;           ///< law of a bond, in place of friction and target
  Vec3 impulse = Vec3::Zero();        ///< on a: a guess before, the solution after [N·s]
  Vec3 given_back = Vec3::Zero();     ///< part of `impulse` by the phase of restitution, likewise [N·s]
  Vec3 velocity = Vec3::Zero();       ///< relative velocity of a to b after the solution [m/s]
  double lift = -1;  ///< friction times sliding speed, likewise [m/s]; negative before: that of free_velocity
};

}  // namespace griffith
