#include "sim/world/contact/quasi_static.h"

#include <algorithm>
#include <span>
#include <vector>

#include "sim/geometry/disjoint_sets.h"
#include "sim/world/bodies/acting_bonds.h"
#include "sim/world/bodies/bodies.h"
#include "sim/world/bodies/supported_motion.h"
#include "sim/world/motion/motion_phase.h"

namespace griffith {
namespace {

/// True if a body cannot deform visibly before it breaks: a beam of length l and thickness t that carries a load in its
/// middle has bent by ε l²/(6 t) where its surface reaches the strain ε. Pieces are seen beside what they broke off.
bool hardly_deforms(const WorldState& world, const Body& body) {
  constexpr double kVisible = 5e-3;  // of the extent of the original
  const Material& material = world.material_of(body);
  const double thickness = body.motion.mass / material.density / (body.extent * body.extent);
  const double strain = min_breaking_stress(world, body, false) / material.young_modulus;
  const double bent = strain * body.extent * body.extent / (6 * thickness);
  return bent < kVisible * world.model->extents[body.scene_body];
}

/// True if a wave crosses a body within `dt` [s]: by an implicit step of that length it comes close to equilibrium.
bool reaches_equilibrium(const WorldState& world, const Body& body, double dt) {
  return body.extent < dt * bar_wave_speed(world.material_of(body));
}

/// Objects that respond to contacts, in groups connected by these, per ProxyId.
struct ContactGroups {
  std::vector<bool> responds;
  std::vector<int> group;  ///< smallest object of the group
};

ContactGroups contact_groups(const WorldState& world) {
  std::size_t objects = world.body_of_proxy.size();
  const std::span<const Contact> contacts = world.contact_world.contacts();
  for (const Contact& contact : contacts)
    objects = std::max<std::size_t>(objects, std::max(contact.a.index(), contact.b.index()) + 1);
  ContactGroups groups{std::vector<bool>(objects, false), std::vector<int>(objects)};
  for (const Contact& contact : contacts)
    for (const ProxyId side : {contact.a, contact.b}) {
      const BodyId id = world.body_of(side);
      groups.responds[side] = world.contact_world.moves(side) || (id.valid() && world.bodies[id].is_deformable());
    }
  DisjointSets sets(static_cast<int>(objects));
  for (const Contact& contact : contacts)
    if (groups.responds[contact.a] && groups.responds[contact.b])
      sets.join(static_cast<int>(contact.a.index()), static_cast<int>(contact.b.index()));
  for (std::size_t i = 0; i < objects; ++i) groups.group[i] = sets.find(static_cast<int>(i));
  return groups;
}

/// Returns the number of responding objects per group.
std::vector<int> sizes_of(const ContactGroups& groups) {
  std::vector<int> sizes(groups.group.size(), 0);
  for (std::size_t i = 0; i < groups.group.size(); ++i) sizes[groups.group[i]] += groups.responds[i];
  return sizes;
}

/// Returns the energy that contacts between objects taken for rigid dissipate by their pressure, per group [J]: ½ of
/// the work against the approach without them.
std::vector<double> dissipated_in(const WorldState& world, const ContactGroups& groups) {
  std::vector<double> dissipated(groups.group.size(), 0);
  const std::span<const Contact> contacts = world.contact_world.contacts();
  const auto is_coupled = [&](ProxyId object) {
    const BodyId id = world.body_of(object);
    return id.valid() && world.bodies[id].is_deformable() && !world.bodies[id].quasi_static;
  };
  for (const Contact& contact : contacts) {
    if (contact.impulse.isZero(0) || is_coupled(contact.a) || is_coupled(contact.b)) continue;
    const int group = groups.group[groups.responds[contact.a] ? contact.a : contact.b];
    dissipated[group] += 0.5 * contact.impulse.dot(contact.normal) * contact.approach;
  }
  return dissipated;
}

/// Scales the velocities that deform a body by `fraction` < 1. Returns the work of the impulses that this takes [J].
double slow(WorldState& world, const Body& body, double fraction) {
  const auto velocities = [&] { return body.system->gather(world.nodes.velocities, world.edges.velocities); };
  const NodeVectors before = velocities();
  slow_deformation(world, body, fraction);
  const NodeVectors removed = before - velocities();
  NodeVectors impulses;
  multiply(body.system->matrix(), removed, impulses);
  return fraction / (1 - fraction) * dot(impulses, removed);
}

}  // namespace

std::vector<Vec3> touching_places(const WorldState& world) {
  std::vector<Vec3> places = world.nodes.positions;
  for (const Body& body : world.bodies) {
    if (!body.quasi_static || !body.is_deformable()) continue;
    const Mat3 rotation = body.orientation.toRotationMatrix();
    for (std::size_t i = 0; i < body.nodes.size(); ++i)
      places[body.nodes[i]] = body.motion.center + rotation * body.reference_arms.col(static_cast<Eigen::Index>(i));
  }
  return places;
}

void choose_quasi_static_bodies(WorldState& world) {
  constexpr int kLargeGroup = 5;            // objects
  constexpr std::size_t kLargeBody = 4096;  // nodes: factoring its aggregates with contacts takes a tenth of a second
  if (world.integrates_explicitly()) return;
  const double time_step = world.model->scene.simulation.time_step;
  const ContactGroups groups = contact_groups(world);
  const std::vector<int> sizes = sizes_of(groups);
  const std::vector<bool> has_bonds = bodies_with_bonds(world);
  for (Body& body : world.bodies) {
    const int group = sizes[groups.group[body.proxy]];
    const bool is_costly = group > kLargeGroup || (group > 0 && body.nodes.size() > kLargeBody);
    body.quasi_static = is_costly && !has_bonds[body.id.index()] && reaches_equilibrium(world, body, time_step) &&
                        hardly_deforms(world, body) && !body.guided && !is_driven(world, body);
  }
}

void stop_waves(WorldState& world) {
  for (const Body& body : world.bodies)
    if (body.quasi_static && body.is_deformable()) stop_deforming(world, body);
}

void limit_deformation(WorldState& world, const TouchedBodies& touched, std::span<const int> bodies) {
  const ContactGroups groups = contact_groups(world);
  std::vector<double> given = dissipated_in(world, groups), taken(given.size(), 0), works(bodies.size(), 0);
  const auto body_at = [&](std::size_t i) -> const Body& { return world.bodies[touched.bodies[bodies[i]].body]; };
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (!body_at(i).quasi_static) continue;
    works[i] = deforming_work(world, body_at(i), world.scratch.contact_impulses);
    taken[groups.group[body_at(i).proxy]] += std::max(0.0, works[i]);
  }
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const int group = groups.group[body_at(i).proxy];
    if (works[i] <= 0 || taken[group] <= given[group]) continue;
    const double fraction = std::max(0.0, given[group]) / taken[group];
    world.energy.regime_change += slow(world, body_at(i), fraction);
    world.scratch.bodies[body_at(i).id].contact_work -= (1 - fraction) * works[i];
  }
}

}  // namespace griffith
