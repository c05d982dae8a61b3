#include "sim/world/bodies/impact_speeds.h"

#include <algorithm>
#include <limits>
#include <numbers>

#include "sim/world/bodies/bodies.h"
#include "sim/world/bodies/expected_impacts.h"

namespace griffith {
namespace {

/// True if the damping of a body's material, which microsteps leave out, takes more than a twentieth of the speed at
/// which it rebounds: a vibration of the frequency ω = π/T is damped by exp(−(α + β ω²) T/2) in an impact of duration
/// T.
bool is_damped_within(const WorldState& world, const Body& body) {
  constexpr double kNegligible = 0.05;
  const Material& material = world.material_of(body);
  const double duration = impact_window(world, body), frequency = std::numbers::pi / duration;
  return (material.mass_damping + material.stiffness_damping * frequency * frequency) * duration / 2 > kNegligible;
}

}  // namespace

double harmful_impact_speed(const WorldState& world, const Body& body) {
  constexpr std::size_t kCell = 6;  // tets
  constexpr double kOfOneCell = 3;  // damage speeds
  const auto is_front = [&](NodeId node) { return world.nodes.at_crack_front[node] != 0; };
  const bool is_cell = body.tets.size() <= kCell && std::ranges::none_of(body.nodes, is_front);
  return (is_cell ? kOfOneCell : 1) * damage_speed(world, body);
}

bool stands_large_strains(const Material& material) {
  constexpr double kLarge = 0.05;
  return material.tensile_strength >= kLarge * material.young_modulus;
}

double impact_window(const WorldState& world, const Body& body) {
  return kTransits * body.extent / bar_wave_speed(world.material_of(body));
}

bool responds_slowly(const WorldState& world, const Body& body) {
  constexpr double kSmall = 1.0 / 8;
  return impact_window(world, body) > kSmall * world.model->scene.simulation.time_step;
}

bool rebounds(const WorldState& world, const Body& body) {
  return stands_large_strains(world.material_of(body)) && !is_thin(body) && responds_slowly(world, body) &&
         !is_damped_within(world, body);
}

double rebound_speed(const WorldState& world, const Body& body) {
  if (!rebounds(world, body)) return std::numeric_limits<double>::infinity();
  return std::max(visible_speed(world, body), min_impact_speed(world));
}

double examined_impact_speed(const WorldState& world, const Body& body) {
  return std::min(harmful_impact_speed(world, body), rebound_speed(world, body));
}

}  // namespace griffith
