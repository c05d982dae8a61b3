#include "sim/world/world.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "sim/core/hash_bytes.h"
#include "sim/world/bodies/bodies.h"
#include "sim/world/bodies/impact_speeds.h"
#include "sim/world/conditions/grab.h"
#include "sim/world/conditions/projectiles.h"
#include "sim/world/conditions/push.h"
#include "sim/world/contact/contact_phase.h"
#include "sim/world/energy/energy_phase.h"
#include "sim/world/explicit/explicit_regime.h"
#include "sim/world/fracture/separation_phase.h"
#include "sim/world/motion/elastic_phase.h"
#include "sim/world/motion/equilibrium.h"
#include "sim/world/motion/explicit_integration.h"
#include "sim/world/output/publish.h"
#include "sim/world/regime/regime_change.h"
#include "sim/world/setup/build_world.h"
#include "sim/world/setup/residual_strains.h"
#include "sim/world/state/hash_state.h"
#include "sim/world/state/world_state.h"
#include "sim/world/step.h"

namespace griffith {

struct World::Impl {
  WorldState state;
};

namespace {

/// Takes on the material that is in force now.
void change_bodies(WorldState& world, int scene_body) {
  for (Body& body : world.bodies) {
    if (body.scene_body != scene_body) continue;
    if (body.explicit_state) end_explicit(world, body);
    for (NodeId node : body.nodes) world.nodes.masses[node] = node_mass(world, node);
    for (EdgeId edge : body.edges) world.edges.masses[edge] = edge_mass(world, edge);
    rebuild_body(world, body);
    const Material& material = world.material_of(body);
    world.contact_world.set_surface(body.proxy, {material.friction, material.restitution});
  }
}

/// True if two materials differ only in their resistance to cracks, so that motion is unchanged.
bool differ_in_resistance_alone(Material a, const Material& b) {
  a.tensile_strength = b.tensile_strength;
  a.compressive_strength = b.compressive_strength;
  a.fracture_toughness = b.fracture_toughness;
  a.separation_toughness = b.separation_toughness;
  return a == b;
}

void change_resistance(WorldState& world, int scene_body) {
  for (const Body& body : world.bodies)
    if (body.scene_body == scene_body)
      world.contact_world.set_impact_speed(body.proxy, examined_impact_speed(world, body));
}

/// Restores the undeformed shape before the first step, from which the static start is found.
void restore_start(WorldState& world, int scene_body) {
  for (const Body& body : world.bodies) {
    if (body.scene_body != scene_body) continue;
    for (NodeId node : body.nodes) world.nodes.positions[node] = world.mesh->rest_positions[node];
    for (EdgeId edge : body.edges) world.edges.offsets[edge].setZero();
    for (TetId tet : body.tets) world.elements.states.edit()[tet] = {};
  }
  reset_residual_strains(world, scene_body, world.elements);
}

/// Evaluates separation again under the present material. `stays`: the stress is the same. Postponed cracks are
/// dropped, since others would have to open.
void evaluate_edited(WorldState& world, int scene_body, bool stays) {
  std::erase_if(world.postponed,
                [&](const PostponedCrack& crack) { return body_at(world, crack.node).scene_body == scene_body; });
  if (stays) return reevaluate_separation(world, scene_body);
  for (const Body& body : world.bodies)
    if (body.scene_body == scene_body) evaluate_separation(world, body);
}

/// Returns the memory of a mesh and its stars [bytes].
std::size_t mesh_memory(const TetMesh& mesh) {
  return mesh.rest_positions.size() * (sizeof(Vec3) + sizeof(std::vector<TetId>)) +
         mesh.tets.size() * 12 * sizeof(TetId);
}

}  // namespace

World::World(const Scene& scene, const Monitor& monitor) : World(scene, InMemoryMeshes(), monitor) {}
World::World(const Scene& scene, const InMemoryMeshes& meshes, const Monitor& monitor)
    : impl_(std::make_unique<Impl>(build_world(scene, monitor, meshes))) {}
World::~World() = default;
World::World(const World& other) : World(std::make_unique<Impl>(*other.impl_)) {}
World::World(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {
  WorldState& world = impl_->state;  // views refer to data of the bodies of this world
  for (BodyView& view : world.output.bodies) view.collision_parts = world.bodies[view.id].collision_parts;
}
World& World::operator=(const World& other) { return *this = World(other); }
World::World(World&&) noexcept = default;
World& World::operator=(World&&) noexcept = default;

Frame World::frame() const {
  const WorldState& world = impl_->state;
  Frame frame;
  frame.step = world.step;
  frame.time = world.time;
  frame.nodes.rest_positions = world.mesh->rest_positions;
  frame.nodes.positions = world.nodes.positions;
  frame.nodes.points = world.model->points;
  frame.nodes.velocities = world.nodes.velocities;
  frame.nodes.masses = world.nodes.masses;
  frame.nodes.has_support = world.nodes.has_support;
  frame.nodes.constraints = world.nodes.constraints;
  frame.nodes.load_forces = world.output.load_forces;
  frame.nodes.at_crack_front = world.nodes.at_crack_front;
  frame.nodes.separations = world.nodes.separations;
  frame.nodes.reactions = world.nodes.reactions;
  frame.elements.tets = world.mesh->tets;
  frame.elements.neighbors = world.mesh->neighbors;
  frame.elements.bodies = world.elements.bodies;
  frame.elements.first_surface = world.elements.first_surface;
  frame.elements.opened = world.elements.opened;
  frame.nodes.stars = world.mesh->stars;
  frame.elements.rest_elements = world.elements.rest_elements;
  frame.elements.states = world.elements.states;
  frame.elements.stresses = world.elements.stresses;
  frame.elements.edges = world.tet_edges->of_tet;
  frame.elements.quadratic_states = world.elements.quadratic_states;
  frame.edges.ends = world.tet_edges->ends;
  frame.edges.offsets = world.edges.offsets;
  frame.materials = world.materials;
  frame.weaknesses = world.model->weaknesses;
  frame.bodies = world.output.bodies;
  frame.splinters.splinters = world.model->splinters.splinters;
  frame.splinters.parts = world.model->splinters.parts;
  frame.splinters.faces = world.model->splinters.faces;
  frame.splinters.corners = world.model->splinters.corners;
  frame.splinters.attached = world.splinter_state.attached;
  frame.splinters.open_walls = world.splinter_state.open_walls;
  frame.projectiles = world.output.projectiles;
  frame.contacts = world.output.contacts;
  frame.grab = grab_view(world);
  frame.probes = world.probes;
  frame.crack_events = world.crack_events;
  frame.fragments = static_cast<int>(
      std::count_if(world.bodies.begin(), world.bodies.end(), [](const Body& body) { return body.parent.valid(); }));
  frame.totals = world.output.totals;
  frame.energy = frame.energy_of_step = world.energy;
  frame.energy_of_step -= world.energy_before;
  frame.report = world.report;
  frame.element_choices = world.model->element_choices;
  return frame;
}

void World::step() { advance(impl_->state); }

void World::step(const MicrostepObserver& observer) {
  MicrostepWatch watch{.wants = observer.wants,
                       .take =
                           [&](std::int64_t microstep, WorldState&& moment) {
                             observer.take(microstep, World(std::make_unique<Impl>(Impl{std::move(moment)})));
                           },
                       .undo = observer.undo};
  impl_->state.watch = &watch;
  advance(impl_->state);
  impl_->state.watch = nullptr;
}

const std::vector<InputError>& World::findings() const { return impl_->state.model->findings; }

ProjectileBurst World::fire(const ProjectileBurst& burst) { return fire_burst(impl_->state, burst); }

void World::grab(const Grab& grab) { begin_grab(impl_->state, grab); }
void World::move_grab(const Vec3& target) { griffith::move_grab(impl_->state, target); }
void World::release() { end_grab(impl_->state); }
void World::push(const Push& push) { begin_push(impl_->state, push); }

void World::set_material(int scene_body, const Material& material) {
  WorldState& world = impl_->state;
  if (scene_body < 0 || scene_body >= static_cast<int>(world.materials.size()))
    throw InputError("material", "is of body " + std::to_string(scene_body) + ", which is none of the scene",
                     "use an index of Scene::bodies");
  check_substep_count(world, scene_body, material);
  check_residual_stress(world.model->scene, scene_body, material);
  const EnergyNow before = energy_now(world);
  world.in_equilibrium = false;
  const bool stays = world.step > 0 && differ_in_resistance_alone(world.materials[scene_body], material);
  world.materials[scene_body] = material;
  allow_flow(world);
  if (world.step == 0) restore_start(world, scene_body);
  for (Body& body : world.bodies)
    if (body.scene_body == scene_body && body.asleep && !body.rigid) make_elastic(world, body);
  stays ? change_resistance(world, scene_body) : change_bodies(world, scene_body);
  if (world.step == 0) {
    find_static_start(world, scene_body);
    place_proxies(world);
  }
  update_elements(world);
  evaluate_edited(world, scene_body, stays);
  account_edit(world, before);
  publish(world);
}

std::size_t World::memory(const World* beside) const {
  const WorldState& world = impl_->state;
  const WorldState* other = beside ? &beside->impl_->state : nullptr;
  std::size_t size = sizeof(WorldState) + world.nodes.memory() + world.edges.memory() + world.contact_world.memory();
  size += world.elements.memory(other ? &other->elements : nullptr);
  if (!other || !world.mesh.shares_with(other->mesh)) size += mesh_memory(world.mesh);
  if (!other || !world.tet_edges.shares_with(other->tet_edges))
    size += 2 * world.tet_edges->ends.size() * sizeof(NodeId) + 6 * world.tet_edges->of_tet.size() * sizeof(EdgeId);
  for (std::size_t i = 0; i < world.bodies.size(); ++i) {
    const Body& body = world.bodies[i];
    size += sizeof(Body) + body.tets.size() * sizeof(TetId) + body.surface.size() * sizeof(SurfaceFace) +
            body.nodes.size() * (sizeof(NodeId) + sizeof(Vec3));
    for (const ConvexPart& part : body.collision_parts) size += part.size() * sizeof(Vec3);
    const bool has_other = other && i < other->bodies.size() && other->bodies[i].system;
    if (body.system) size += body.system->memory(has_other ? &*other->bodies[i].system : nullptr);
  }
  for (const CrackEvent& event : world.crack_events)
    size += sizeof(CrackEvent) + event.elements.size() * sizeof(CrackElement);
  size += world.splinter_state.open.size() + world.splinter_state.attached.size();
  return size;
}

std::uint64_t World::state_hash() const {
  const WorldState& world = impl_->state;
  const std::uint64_t motion = hash_values(world.nodes.velocities, hash_values(world.nodes.positions));
  return hash_values(world.elements.bodies, hash_values(world.mesh->tets, motion));
}

StateHashes World::state_hashes() const { return hash_state(impl_->state); }
const Scene& World::scene() const { return impl_->state.model->scene; }
const TetSoup* World::filled_surface(int scene_body) const {
  return impl_->state.model->filled_surfaces[scene_body].get();
}

}  // namespace griffith
