#pragma once

#include <vector>

#include "sim/solver/contact_problem.h"
#include "sim/world/contact/touched_body.h"
#include "sim/world/state/world_state.h"

namespace griffith {

/// Objects whose contacts and bonds affect one another, and these.
struct ContactGroup {
  std::vector<int> contacts;  ///< indices into contacts()
  std::vector<int> touched;   ///< indices of the deformable bodies in TouchedBodies
  std::vector<DeformableInertia> deformable;
  std::vector<RigidInertia> rigid;
  std::vector<FrictionContact> problem;   ///< per contact, then per bonded pair and tied edge of the touched bodies
  std::vector<double> target_velocities;  ///< likewise, of bodies that do not turn [m/s]
  int unconverged = 0;                    ///< contacts that do not meet their law
  double tolerance = 0;                   ///< at least this, relative, where it is solved again
};

/// Builds the problems of all groups with deformable bodies, after ContactWorld::solve(); last those of single bodies
/// with bonds that nothing touches.
std::vector<ContactGroup> build_contact_groups(const WorldState& world, const TouchedBodies& touched, double dt);

/// Returns the inertia of a body against velocity changes in a substep of `dt` [s].
DeformableInertia deformable_inertia(const WorldState& world, const Body& body, double dt,
                                     bool factors_with_contacts = false);

/// Returns the motions of a body as a whole within its supports, for the present positions of its nodes, in a substep
/// of `dt` [s].
WholeMotion whole_motion(const WorldState& world, const Body& body, double dt);

}  // namespace griffith
