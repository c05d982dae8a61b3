#pragma once

#include "sim/core/linear_algebra.h"

namespace griffith {

/// Constraint of a node by supports: its velocity is unknown in the allowed directions and known in the others.
///   nothing blocked    free
///   one direction      slides in a plane: a symmetry plane, a frictionless base
///   two                slides along a line: where two such planes meet
///   three              held: still, or moving with a prescribed velocity
/// In the world frame; the directions do not change while the node moves.
struct NodeConstraint {
  Mat3 allowed = Mat3::Identity();  ///< projector onto the unknown velocities: I free, I − n nᵀ in a plane, 0 held
  Vec3 velocity = Vec3::Zero();     ///< the known part [m/s]: allowed · velocity = 0; may change from step to step
  int blocked = 0;                  ///< how many directions are known, 0..3

  bool is_free() const { return blocked == 0; }
  bool is_held() const { return blocked == 3; }

  /// All three components known: `velocity` [m/s], zero for a fixed node.
  static NodeConstraint held(const Vec3& velocity = Vec3::Zero());
  /// Slides in the plane with this normal (any length but 0), which moves at `speed` along it [m/s].
  static NodeConstraint sliding(const Vec3& normal, double speed = 0);

  /// Adds the condition direction · v = speed (direction of any length but 0, speed along its unit vector [m/s]). One
  /// that follows from earlier conditions, or contradicts them, changes nothing: who comes first wins.
  void block(const Vec3& direction, double speed);
};

/// Returns the constraint of the midpoint of an edge relative to its ends: directions blocked at both ends are blocked
/// between them.
NodeConstraint constraint_between(const NodeConstraint& a, const NodeConstraint& b);

}  // namespace griffith
