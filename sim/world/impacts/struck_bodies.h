#pragma once

#include <array>
#include <span>
#include <vector>

#include "sim/world/state/world_state.h"

namespace griffith {

/// Impact that could damage one of two objects by waves.
struct Impact {
  ContactWorld::Encounter met;
  std::array<BodyId, 2> bodies;   ///< invalid: a projectile or the ground
  std::array<bool, 2> deforms{};  ///< whether its waves are to be followed
  std::array<ProxyId, 2> objects() const { return {met.a, met.b}; }
};

/// True if one of the two is a projectile.
bool is_shot(const WorldState& world, const Impact& impact);

/// True if a body is one for microsteps, struck at this speed [m/s]: their elements stand no large strains, nor large
/// turns in a microstep. What is soft, or spins nearly as fast as its waves run, or has elements so small or flat that
/// a wave crosses many others in a microstep of theirs, is left to the implicit step.
bool suits_microsteps(const WorldState& world, const Body& body, double impact_speed);

/// True if microsteps can follow an impact at this speed on a body that rebounds, as long as it does not crack [m/s].
bool suits_rebound(const WorldState& world, const Body& body, double impact_speed);
/// True if they can, and the object that it strikes hardly deforms beside it, which microsteps know as a rigid
/// obstacle: the ground, a projectile, or a body at least ten times as stiff.
bool suits_rebound_from(const WorldState& world, const Body& body, ProxyId object, double impact_speed);

/// True if two pieces of one body have just parted: what they do to each other then is no impact.
bool have_just_parted(const WorldState& world, BodyId a, BodyId b);

/// Returns the impacts within `duration` [s] that are fast enough to damage bodies not in explicit dynamics yet. All
/// others, mostly of debris, are left to the implicit step.
std::vector<Impact> harmful_impacts(const WorldState& world, double duration);
/// Returns those of `encounters` that are fast enough for that.
std::vector<Impact> harmful_among(const WorldState& world, std::span<const ContactWorld::Encounter> encounters);

}  // namespace griffith
