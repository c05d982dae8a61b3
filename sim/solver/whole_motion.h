#pragma once

#include "sim/core/linear_algebra.h"
#include "sim/solver/block_sparse_matrix.h"
#include "sim/solver/pivot.h"

namespace griffith {

/// The motions of a deformable body as a whole that nothing resists but its mass: all of a free one, turns about a
/// pivot of one that supports hold there. Their momentum balances exactly, whatever stress does in the linearized A.
struct WholeMotion {
  NodeVectors arms = {};        ///< arms of nodes from the center of mass or the pivot, then offsets of edges [m]
  Eigen::VectorXd masses = {};  ///< masses of the nodes [kg]
  double inverse_mass = 0;      ///< 0 at a pivot [1/kg]
  Mat3 inverse_inertia = Mat3::Zero();  ///< 0 across the axes of a pivot [1/(kg·m²)]
  double damping = 1;                   ///< 1 + h·alpha, by which mass resists in an implicit step
  bool exists() const { return arms.cols() > 0; }
  Vec3 spin_of(const Eigen::Ref<const NodeVectors>& velocities) const;
  /// Returns the motion as a whole that has the momentum of these velocities: Q v.
  NodeVectors part_of(const Eigen::Ref<const NodeVectors>& velocities) const;
  /// Returns the momentum by which these impulses move the whole: Qᵀ p.
  NodeVectors momentum_of(const Eigen::Ref<const NodeVectors>& impulses) const;
};

/// Motions of a free body as a whole. `places`: positions of its nodes, then offsets of its edges [m]; `masses`: of its
/// nodes [kg].
WholeMotion free_motion(NodeVectors places, Eigen::VectorXd masses);
/// Motions of a body as a whole that turns about a pivot.
WholeMotion swinging_motion(NodeVectors places, Eigen::VectorXd masses, const Pivot& pivot);

}  // namespace griffith
