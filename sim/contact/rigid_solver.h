#pragma once

#include <span>
#include <vector>

#include "sim/core/linear_algebra.h"

namespace griffith::contact {

/// Rigid body in a step, about its center of mass or the place of its hinge.
struct RigidBody {
  bool moves = false;                                 ///< true if contacts move it
  bool is_hinged = false;                             ///< not moved out of overlaps
  double inverse_mass = 0;                            ///< [1/kg]
  bool is_round = false;                              ///< turning does not change its gaps
  Mat3 inverse_inertia = Mat3::Zero();                ///< world frame, as it lies when the step begins [1/(kg·m²)]
  Vec3 velocity = Vec3::Zero(), spin = Vec3::Zero();  ///< at the start, then at the end [m/s], [rad/s]
  Vec3 acceleration = Vec3::Zero(), turning = Vec3::Zero();   ///< change by all but contacts [m/s²], [rad/s²]
  Vec3 displacement = Vec3::Zero(), rotation = Vec3::Zero();  ///< found: by its velocities in the step [m], [rad]
  bool touched = false;                                       ///< found: a contact pushed it, or is about to
  Vec3 push = Vec3::Zero(), push_rotation = Vec3::Zero();     ///< found: out of overlaps [m], [rad]
};

/// Point where two rigid bodies touch or may touch within the step.
struct RigidContact {
  int a = 0, b = 0;                                 ///< bodies
  Vec3 normal = Vec3::Zero();                       ///< unit, from b to a
  Vec3 arm_a = Vec3::Zero(), arm_b = Vec3::Zero();  ///< arms from the centers or hinges [m]
  bool is_mean = false;         ///< arms are the means in the step: its end decides, not the way there
  double fallen = 0;            ///< depth along gravity: sweeps downward through a pile carry its load at once
  double distance = 0;          ///< [m], negative where they overlap by more than is allowed
  double resting = 0;           ///< overlap that stays [m]
  double friction = 0;          ///< Coulomb's coefficient
  double restitution = 0;       ///< coefficient of the normal velocity; 0 without an impact
  double approach = 0;          ///< approach speed in the step without contacts [m/s]
  double fall = 0;              ///< part of it by external forces in the step [m/s]
  Vec3 force = Vec3::Zero();    ///< on a: of the last step; then of this one's last substep [N]
  Vec3 impulse = Vec3::Zero();  ///< found: on a [N·s]
  Vec3 couple = Vec3::Zero();   ///< found: angular impulse on both beyond that at the arms [N·m·s]
};

/// Bodies connected by contacts: indices of both.
struct RigidGroup {
  std::vector<int> bodies, contacts;
  double change = 0;  ///< found: of a velocity by the last sweep, infinite for large groups [m/s]
};

/// Moves each group of rigid bodies through a step of `dt` [s] > 0 in substeps, each started from the impulses of the
/// last: small substeps converge faster than sweeps (Macklin et al. 2019; Catto 2023). Contacts push only and within
/// Coulomb's friction; gaps close within a substep at most, so that nothing gets into anything that was foreseen.
/// Impulses act along the normals of the step's start, half-way between where both bodies have carried the contact:
/// they keep momentum, linear and angular. Overlaps go by displacements that add no velocity. What strikes parts at the
/// end, by a velocity that leads back to restitution² of the height it fell from. Results do not depend on the threads.
/// Returns how many times a contact was solved.
int solve_rigid(std::span<RigidBody> bodies, std::span<RigidContact> contacts, std::span<RigidGroup> groups, double dt);

}  // namespace griffith::contact
