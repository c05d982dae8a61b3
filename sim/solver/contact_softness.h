#pragma once

#include <span>

#include "sim/solver/contact_bodies.h"

namespace griffith {

/// Softness r of a contact [1/kg]: that of the elements that touch, or a small share of what masses alone have. With
/// more, rounds converge slowly; with less, Newton's method does where contacts go from sticking to sliding. Elements
/// of a stiff chip resist a long step 10⁹ times as much as its mass does, too much for the precision of numbers.
double softness_of(std::span<const DeformableInertia> deformable, std::span<const RigidInertia> rigid,
                   const FrictionContact& contact);

}  // namespace griffith
