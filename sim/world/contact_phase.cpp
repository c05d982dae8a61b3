#include <Eigen/LU>
#include <algorithm>

#include "sim/fracture/resistance.h"
#include "sim/parallel.h"
#include "sim/world/phases.h"
#include "sim/world/surface_point.h"

namespace griffith {
namespace {

/// Where a contact touches an elastic body.
struct Touch {
  BodyId body;  ///< invalid where nothing elastic is touched
  SurfacePoint point;
};

Body* body_of(WorldState& world, ProxyId proxy) {
  const std::size_t index = static_cast<std::size_t>(proxy.value);
  const BodyId id = index < world.body_of_proxy.size() ? world.body_of_proxy[index] : BodyId();
  return id.valid() ? &world.bodies[id] : nullptr;
}

Touch touch(WorldState& world, ProxyId proxy, const Vec3& position) {
  Body* body = body_of(world, proxy);
  if (!body || body->rigid) return {};
  return {body->id, closest_surface_point(world, *body, position)};
}

/// Lets the elastic surfaces soften the contacts, so that the stiffness of the material matters.
std::vector<std::array<Touch, 2>> soften_contacts(WorldState& world) {
  const std::span<Contact> contacts = world.contact_world.contacts();
  std::vector<std::array<Touch, 2>> touches(contacts.size());
  parallel_for(static_cast<int>(contacts.size()), 16, [&](int begin, int end) {
    for (int i = begin; i < end; ++i) {
      Contact& contact = contacts[i];
      touches[i] = {touch(world, contact.a, contact.position_on_a), touch(world, contact.b, contact.position_on_b)};
      contact.compliance = 0;
      for (const Touch& t : touches[i])
        if (t.body.valid())
          contact.compliance += surface_compliance(world, world.bodies[t.body], t.point, contact.normal);
    }
  });
  return touches;
}

/// Adds the force and torque of `force` at `position` to a free body as the force field that accelerates it rigidly.
void add_rigid_force(const WorldState& world, const Body& body, const Vec3& force, const Vec3& torque,
                     std::vector<Vec3>& forces) {
  const Vec3 acceleration = force / body.motion.mass;
  const Vec3 angular_acceleration = body.motion.inertia.inverse() * torque;
  for (NodeId node : body.nodes) {
    const Vec3 arm = world.nodes.positions[node] - body.motion.center;
    forces[node] += world.nodes.masses[node] * (acceleration + angular_acceleration.cross(arm));
  }
}

/// Puts a contact's force on the touched corners. The contact point lies a little off the elastic surface: the torque
/// of that offset goes to the whole body, so that angular momentum is kept.
void add_contact_force(const WorldState& world, const Body& body, const Touch& touched, const Vec3& position,
                       const Vec3& force, std::vector<Vec3>& forces) {
  if (!touched.body.valid())
    return add_rigid_force(world, body, force, (position - body.motion.center).cross(force), forces);
  Vec3 touched_position = Vec3::Zero();
  for (int i = 0; i < 3; ++i) {
    forces[touched.point.nodes[i]] += touched.point.weights[i] * force;
    touched_position += touched.point.weights[i] * world.nodes.positions[touched.point.nodes[i]];
  }
  if (!body.supported())
    add_rigid_force(world, body, Vec3::Zero(), (position - touched_position).cross(force), forces);
}

/// Whether a force could bring a rigid piece near its strength somewhere.
bool could_hurt(const WorldState& world, const Body& body, double force) {
  constexpr double kWakingShare = 0.25;
  if (body.tets.size() == 1) return false;
  const double element_size = mean_element_size(world, body);
  const Material& material = world.material_of(body);
  const double limit = resistance(material, true, element_size);
  const double load = material.criterion == FractureCriterion::strength ? force / (element_size * element_size) : force;
  return load > kWakingShare * limit;
}

void wake(WorldState& world, Body& body, double dt) {
  body.rigid = false;
  body.calm_steps = 0;
  assemble_system(world, body, dt);
}

void apply_corrections(WorldState& world) {
  for (Body& body : world.bodies) {
    if (body.supported()) continue;
    const ContactWorld::Correction correction = world.contact_world.position_correction(body.stand_in);
    if (correction.translation.isZero(0) && correction.rotation.isZero(0)) continue;
    for (NodeId node : body.nodes) {
      Vec3& position = world.nodes.positions[node];
      position += correction.translation + correction.rotation.cross(position - body.motion.center);
    }
  }
}

}  // namespace

void place_stand_ins(WorldState& world) {
  for (const Body& body : world.bodies) {
    RigidState state{{body.motion.center, body.orientation}, body.motion.velocity, body.motion.angular_velocity};
    if (body.supported()) state.velocity = state.angular_velocity = Vec3::Zero();
    world.contact_world.set_state(body.stand_in, state);
  }
}

std::vector<Vec3> contact_forces(WorldState& world, double dt) {
  world.contact_world.detect();
  const std::vector<std::array<Touch, 2>> touches = soften_contacts(world);
  world.contact_world.solve(dt);

  std::vector<Vec3> forces(world.nodes.positions.size());
  for (std::size_t i = 0; i < forces.size(); ++i) forces[i] = world.nodes.masses[i] * world.scene.gravity;
  add_load_forces(world, world.time, forces);
  const std::span<const Contact> contacts = world.contact_world.contacts();
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const Contact& contact = contacts[i];
    if (contact.impulse.isZero(0)) continue;
    const Vec3 force = contact.impulse / dt;
    for (int side = 0; side < 2; ++side) {
      Body* body = body_of(world, side == 0 ? contact.a : contact.b);
      if (!body) continue;
      if (body->rigid && could_hurt(world, *body, force.norm())) wake(world, *body, dt);
      add_contact_force(world, *body, touches[i][side], side == 0 ? contact.position_on_a : contact.position_on_b,
                        side == 0 ? force : Vec3(-force), forces);
    }
  }
  apply_corrections(world);
  world.contacts_before = static_cast<int>(contacts.size());
  world.report.contacts = std::max(world.report.contacts, static_cast<int>(contacts.size()));
  world.report.max_penetration = std::max(world.report.max_penetration, world.contact_world.max_penetration());
  return forces;
}

}  // namespace griffith
