#pragma once

#include <span>
#include <vector>

#include "sim/solver/contact_system.h"

namespace griffith {

/// Work and outcome of a solve.
struct ContactSolveReport {
  int newton_steps = 0, iterations = 0;
  int unconverged = 0;  ///< contacts whose law is not met within the tolerance
};

/// Accuracy of a solve.
struct ContactTolerance {
  double relative = 1e-4;          ///< fraction of the largest velocity change required by contacts
  double negligible_speed = 1e-9;  ///< [m/s]
  bool contacts_alone = false;     ///< what bodies do away from contacts is not asked for: no `changes`
  bool continues = false;  ///< impulses are those of nearly the same problem: contacts begin as stiff as elements
  int max_rounds = 30, max_newton_steps = 60, max_iterations = 400;
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
/// Impacts rebound in a second phase by Poisson's hypothesis: each contact gives back of its normal impulse the share
/// by which it would part at its speed of rebound if it were alone, and impulses are found again that are at least
/// those (Glocker & Pfeiffer 1995). Speeds of parting alone would ask the impossible of bodies that interlock.
/// A bond's γ is hold_back() of γ₀ less the velocity of its opening over r; its strength stays.
/// Bodies with factors take part with the rows that contacts touch alone (TouchedInverse).
/// Writes the impulses of `contacts`, and `changes` y of the deformable bodies, one column a row [m/s]. The same bits
/// for any number of threads.
ContactSolveReport solve_contact_problem(ContactSystem& system, std::span<FrictionContact> contacts,
                                         const ContactTolerance& tolerance, std::vector<NodeVectors>& changes);
/// As above, of bodies whose contacts are solved once.
ContactSolveReport solve_contact_problem(std::span<const DeformableInertia> deformable,
                                         std::span<const RigidInertia> rigid, std::span<FrictionContact> contacts,
                                         const ContactTolerance& tolerance, std::vector<NodeVectors>& changes);

}  // namespace griffith
