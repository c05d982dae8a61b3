#pragma once

#include <optional>
#include <span>
#include <vector>

#include "sim/core/linear_algebra.h"
#include "sim/core/point_compliance.h"

namespace griffith::contact {

/// How an object answers impulses, and its velocities so far. A rigid one by mass and inertia, an immovable one not at
/// all, an elastic one by the compliance that couples its contact points.
struct SolverBody {
  double inverse_mass = 0;                      ///< [1/kg]
  Mat3 inverse_inertia = Mat3::Zero();          ///< world frame [1/(kg·m²)]
  Vec3 velocity = Vec3::Zero();                 ///< [m/s]
  Vec3 angular_velocity = Vec3::Zero();         ///< [rad/s]
  const PointCompliance* compliance = nullptr;  ///< elastic: between its contact points
  std::optional<PointMotion> elastic = {};      ///< elastic: of its contact points
};

/// One end of a contact.
struct ContactEnd {
  int solver_body = 0;
  int point = -1;           ///< of an elastic solver body
  Vec3 arm = Vec3::Zero();  ///< from the centre of mass [m]
};

struct ContactConstraint {
  ContactEnd a, b;
  Mat3 axes = Mat3::Identity();  ///< columns: the normal from b to a, and two tangents
  double friction = 0;
  double target_velocity = 0;   ///< of the parting along the normal [m/s]
  Vec3 impulse = Vec3::Zero();  ///< on a, along the axes: a guess before, the solution after [N·s]
};

struct SolverLimits {
  int work = 12'000;                      ///< rows times sweeps, in each group of objects that touch
  int min_sweeps = 14, max_sweeps = 200;  ///< whatever the work
  /// The largest change of velocity in a sweep, as a share of the group's largest speed to correct.
  double tolerance = 1e-5;
};

/// The Signorini–Coulomb problem by projected Gauss–Seidel (Jean & Moreau 1992), each group of objects that touch on
/// its own, quickened by nonlinear conjugate gradients (Silcowitz, Niebe & Erleben 2010): the normal impulse of a row
/// pushes only and keeps its parting speed at or above `target_velocity`; the tangential one stops the sliding within
/// friction's disc. Velocities of the solver bodies hold everything but the rows' impulses before, those too after.
/// Impulses are within their limits however early the sweeps end. Returns how many times a row was solved.
int solve_impulses(std::span<ContactConstraint> constraints, std::span<SolverBody> solver_bodies,
                   const SolverLimits& limits = {});

}  // namespace griffith::contact
