#include "sim/world/impacts/struck_bodies.h"

#include <algorithm>
#include <optional>

#include "sim/world/bodies/bodies.h"
#include "sim/world/bodies/expected_impacts.h"
#include "sim/world/bodies/impact_speeds.h"
#include "sim/world/explicit/body_frequency.h"
#include "sim/world/explicit/similarity.h"

namespace griffith {

namespace {

/// Largest speed of an impact as a fraction of that of waves in a body that may crack, and in one that stays whole.
constexpr double kMaxMach = 0.3, kMaxMachOfRebound = 0.6;

/// True if an impact at this speed is slow against a body's waves [m/s].
bool suits_speed(const WorldState& world, const Body& body, double speed) {
  return speed < kMaxMach * bar_wave_speed(world.material_of(body));
}

/// True if microsteps can follow waves in a body by its motion and its mesh, struck at this speed [m/s], up to a
/// fraction of that of the waves.
bool suits_waves(const WorldState& world, const Body& body, double impact_speed, double max_mach) {
  constexpr double kFar = 0.1;           // strain that it has
  constexpr double kMaxFrequency = 200;  // in bar wave speeds over the mean edge length
  const double wave_speed = bar_wave_speed(world.material_of(body));
  return std::max(impact_speed, inner_speed(world, body)) < max_mach * wave_speed &&
         highest_frequency(world, body) * body.element_size < kMaxFrequency * wave_speed &&
         !(body.is_deformable() && is_strained_by(world, body, kFar));
}

}  // namespace

bool suits_microsteps(const WorldState& world, const Body& body, double impact_speed) {
  return !stands_large_strains(world.material_of(body)) && suits_waves(world, body, impact_speed, kMaxMach);
}

bool suits_rebound(const WorldState& world, const Body& body, double impact_speed) {
  return rebounds(world, body) && suits_waves(world, body, impact_speed, kMaxMachOfRebound);
}

bool suits_rebound_from(const WorldState& world, const Body& body, ProxyId object, double impact_speed) {
  constexpr double kMuchStiffer = 10;
  if (!suits_rebound(world, body, impact_speed)) return false;
  if (world.contact_world.is_ground(object)) return true;
  const BodyId id = world.body_of(object);
  if (!suits_speed(world, body, impact_speed)) return false;  // edges and corners strain it more than the ground does
  if (!id.valid()) return true;
  return !world.bodies[id].guided &&
         world.material_of(world.bodies[id]).young_modulus >= kMuchStiffer * world.material_of(body).young_modulus;
}

bool have_just_parted(const WorldState& world, BodyId a, BodyId b) {
  constexpr double kApart = 0.1;  // [s]
  if (!a.valid() || !b.valid() || world.bodies[a].scene_body != world.bodies[b].scene_body) return false;
  return world.bodies[a].explicit_state || world.bodies[b].explicit_state ||
         world.time - std::max(world.bodies[a].explicit_ended, world.bodies[b].explicit_ended) < kApart;
}

bool is_shot(const WorldState& world, const Impact& impact) {
  for (int i = 0; i < 2; ++i)
    if (!impact.bodies[i].valid() && !world.contact_world.is_ground(impact.objects()[i])) return true;
  return false;
}

namespace {

/// True if a body that hits another without damage to itself must deform too: as a rigid one it would hit up to twice
/// as hard. In a much heavier one, waves spread so far that it hardly deforms. A guided one would not slow down.
bool yields_to(const Body& body, const Body& struck) {
  constexpr double kMuchHeavier = 8;
  return body.motion.mass < kMuchHeavier * struck.motion.mass || body.guided;
}

/// Finds which bodies an impact could damage. Data of a body are computed once.
class ImpactClassifier {
 public:
  explicit ImpactClassifier(const WorldState& world) : world_(world), known_(world.bodies.size()) {}

  /// True if waves are to be followed in the one of two bodies that is not in explicit dynamics yet, `other` the one
  /// that it meets.
  bool deforms(BodyId id, BodyId other, double approach) {
    if (!id.valid() || world_.bodies[id].explicit_state || world_.bodies[id].tets.size() == 1) return false;
    if (could_damage(id, approach)) return true;
    return could_damage(other, approach) && yields_to(world_.bodies[id], world_.bodies[other]) && suits(id, approach);
  }

 private:
  struct Known {
    double harmful_impact_speed = 0;  ///< [m/s]
    bool suits = false;               ///< microsteps, at no speed of impact
  };

  bool suits(BodyId id, double approach) { return known(id).suits && suits_speed(world_, world_.bodies[id], approach); }
  bool could_damage(BodyId id, double approach) {
    return id.valid() && approach >= known(id).harmful_impact_speed && suits(id, approach);
  }
  const Known& known(BodyId id) {
    std::optional<Known>& of_body = known_[id];
    const Body& body = world_.bodies[id];
    if (!of_body) of_body = Known{harmful_impact_speed(world_, body), suits_microsteps(world_, body, 0)};
    return *of_body;
  }

  const WorldState& world_;
  std::vector<std::optional<Known>> known_;
};

/// True if a body rebounds by its own elasticity. Two soft ones do not: microsteps follow the waves of one of them.
bool bounces(const WorldState& world, const Impact& impact, int side) {
  const BodyId id = impact.bodies[side];
  if (!id.valid()) return false;
  const Body& body = world.bodies[id];
  return !body.explicit_state && impact.met.approach >= rebound_speed(world, body) &&
         suits_rebound_from(world, body, impact.objects()[1 - side], impact.met.approach);
}

}  // namespace

std::vector<Impact> harmful_impacts(const WorldState& world, double duration) {
  const auto may_begin = [&](BodyId id) { return id.valid() && !world.bodies[id].explicit_state; };
  const auto matters = [&](BodyId a, BodyId b) {
    return (may_begin(a) || may_begin(b)) && !have_just_parted(world, a, b);
  };
  return harmful_among(world, expected_impacts(world, duration, matters));
}

std::vector<Impact> harmful_among(const WorldState& world, std::span<const ContactWorld::Encounter> encounters) {
  std::vector<Impact> impacts;
  ImpactClassifier classifier(world);
  for (const ContactWorld::Encounter& met : encounters) {
    Impact impact{met, {world.body_of(met.a), world.body_of(met.b)}, {}};
    for (int i = 0; i < 2; ++i)
      impact.deforms[i] =
          classifier.deforms(impact.bodies[i], impact.bodies[1 - i], met.approach) || bounces(world, impact, i);
    if (impact.deforms[0] || impact.deforms[1]) impacts.push_back(impact);
  }
  return impacts;
}

}  // namespace griffith
