#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "sim/world/world.h"
#include "tests/world/contact/contact_case.h"

namespace griffith::testing {

inline constexpr double kEarthGravity = 9.81;

inline Material preset(const char* key) { return find_material_preset(key).value(); }

inline Material unbreakable(Material material) {
  material.tensile_strength = material.fracture_toughness = 1e13;
  return material;
}

/// A box whose cells have the edges `element` / refinement [m].
inline BodyDescription box(const std::string& name, const Vec3& size, const Vec3& position, const Material& material,
                           const Vec3& element) {
  BodyDescription body;
  body.name = name;
  body.shape = BoxShape{size, element, BoxPattern::five_tet};
  body.position = position;
  body.material = material;
  return body;
}

inline Scene empty_scene(const ContactCase& at) {
  Scene scene;
  scene.simulation.time_step = at.time_step;
  return scene;
}

inline void run_to(World& world, double time) {
  while (world.frame().time < time - 0.5 * world.scene().simulation.time_step) world.step();
}

inline bool has_crack(const Frame& frame) { return !frame.crack_events.empty(); }

inline bool all_asleep(const Frame& frame) {
  return std::ranges::all_of(frame.bodies, [](const BodyView& body) { return body.asleep; });
}

/// Steps on to `time` [s], or until everything sleeps.
inline void run_to_rest(World& world, double time) {
  while (world.frame().time < time - 1e-9 && !all_asleep(world.frame())) world.step();
}

inline std::vector<Vec3> positions_of(const Frame& frame) {
  return {frame.nodes.positions.begin(), frame.nodes.positions.end()};
}

/// The farthest that a node is from where it was [m].
inline double farthest_moved(const std::vector<Vec3>& before, const Frame& frame) {
  double moved = 0;
  for (std::size_t node = 0; node < before.size(); ++node)
    moved = std::max(moved, (frame.nodes.positions[node] - before[node]).norm());
  return moved;
}

/// Returns the depth of the lowest node below `height` [m].
inline double depth_below(const Frame& frame, double height = 0) {
  double lowest = height;
  for (const Vec3& position : frame.nodes.positions) lowest = std::min(lowest, position.y());
  return height - lowest;
}

/// The share of the energy turned over that is there without having been put in; of `least` [J] where that is more.
inline double energy_gained(const EnergyAccount& energy, double least = 1e-30) {
  return (energy.stored() - energy.put_in()) / std::max(energy.turned_over(), least);
}

inline double energy_unaccounted(const EnergyAccount& energy, double least = 1e-30) {
  return std::abs(energy.unaccounted()) / std::max(energy.turned_over(), least);
}

/// Runs to `time`, and asks that in no step there is more energy than was put in, within a percent of what was turned
/// over, and that no more than that is unaccounted for.
inline void check_energy(World& world, double time) {
  double gained = -1, unaccounted = 0;
  while (world.frame().time < time - 1e-9) {
    world.step();
    gained = std::max(gained, energy_gained(world.frame().energy));
    unaccounted = std::max(unaccounted, energy_unaccounted(world.frame().energy));
  }
  check_at_most("energy gained", gained, 0.01);
  check_at_most("energy unaccounted", unaccounted, 0.01);
}

}  // namespace griffith::testing
