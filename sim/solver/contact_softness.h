#pragma once

#include <span>

#include "sim/solver/contact_bodies.h"

namespace griffith {

/// Softness r of a contact [1/kg] in the rounds of a solve. With more, rounds converge slowly; with less, Newton's
/// method does where contacts go from sticking to sliding.
struct ContactSoftness {
  double first = 1;    ///< softness of the first round
  double settled = 1;  ///< largest at which impulses are accepted: above it those between stiff bodies are inexact
  double least = 1;    ///< smallest, for contacts that converge slowly
};

/// Softness of the elements that touch, or a small share of what masses alone have. Elements of a stiff chip resist a
/// long step 10⁹ times as much as its mass does. There the first rounds find which contacts carry, with a share of the
/// compliance of the whole chip, and the last ones how much each does.
ContactSoftness softness_of(std::span<const DeformableInertia> deformable, std::span<const RigidInertia> rigid,
                            const FrictionContact& contact);

}  // namespace griffith
