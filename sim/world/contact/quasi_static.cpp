#include "sim/world/contact/quasi_static.h"

#include <algorithm>
#include <span>
#include <vector>

#include "sim/geometry/disjoint_sets.h"
#include "sim/world/bodies/bodies.h"
#include "sim/world/motion/motion_phase.h"

namespace griffith {
namespace {

bool is_driven(const WorldState& world, const Body& body) {
  return std::ranges::any_of(body.system->supports(),
                             [&](NodeId node) { return !world.nodes.constraints[node].velocity.isZero(0); });
}

/// True if a body cannot deform visibly before it breaks: a beam of length l and thickness t that carries a load in its
/// middle has bent by ε l²/(6 t) where its surface reaches the strain ε.
bool hardly_deforms(const WorldState& world, const Body& body) {
  constexpr double kVisible = 5e-3;  // of its extent
  const Material& material = world.material_of(body);
  const double thickness = body.motion.mass / material.density / (body.extent * body.extent);
  const double strain = min_breaking_stress(world, body, false) / material.young_modulus;
  return strain * body.extent / (6 * thickness) < kVisible;
}

/// Returns the number of objects in the group of each object that contacts move, per ProxyId.
std::vector<int> group_sizes(const WorldState& world) {
  std::size_t objects = world.body_of_proxy.size();
  const std::span<const Contact> contacts = world.contact_world.contacts();
  for (const Contact& contact : contacts)
    objects = std::max<std::size_t>(objects, std::max(contact.a.index(), contact.b.index()) + 1);
  std::vector<bool> responds(objects, false);
  for (const Contact& contact : contacts)
    for (const ProxyId side : {contact.a, contact.b}) {
      const BodyId id = world.body_of(side);
      responds[side] = world.contact_world.moves(side) || (id.valid() && world.bodies[id].is_deformable());
    }
  DisjointSets sets(static_cast<int>(objects));
  for (const Contact& contact : contacts)
    if (responds[contact.a] && responds[contact.b])
      sets.join(static_cast<int>(contact.a.index()), static_cast<int>(contact.b.index()));
  std::vector<int> counts(objects, 0), of_object(objects, 0);
  for (std::size_t i = 0; i < objects; ++i) counts[sets.find(static_cast<int>(i))] += responds[i];
  for (std::size_t i = 0; i < objects; ++i) of_object[i] = counts[sets.find(static_cast<int>(i))];
  return of_object;
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

bool reaches_equilibrium(const WorldState& world, const Body& body, double dt) {
  return body.extent < dt * bar_wave_speed(world.material_of(body));
}

void choose_quasi_static_bodies(WorldState& world) {
  constexpr int kLargeGroup = 5;            // objects
  constexpr std::size_t kLargeBody = 4096;  // nodes: factoring its aggregates with contacts takes a tenth of a second
  if (world.integrates_explicitly()) return;
  const double time_step = world.model->scene.simulation.time_step;
  const std::vector<int> sizes = group_sizes(world);
  for (Body& body : world.bodies) {
    const int group = sizes[body.proxy];
    const bool is_costly = group > kLargeGroup || (group > 0 && body.nodes.size() > kLargeBody);
    body.quasi_static = is_costly && reaches_equilibrium(world, body, time_step) && hardly_deforms(world, body) &&
                        !is_driven(world, body);
    if (body.quasi_static && body.is_deformable()) stop_deforming(world, body);
  }
}

}  // namespace griffith
