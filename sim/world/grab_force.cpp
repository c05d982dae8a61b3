#include "sim/world/grab_force.h"

#include <Eigen/LU>

#include "sim/solver/contact_response.h"
#include "sim/world/conditions/grab.h"
#include "sim/world/conditions/material_point.h"
#include "sim/world/contact/group_builder.h"
#include "sim/world/motion/elastic_phase.h"
#include "sim/world/state/world_state.h"

namespace griffith {
namespace {

/// Returns the velocity of a point of a rigid piece by a unit impulse there, both along `direction` [1/kg].
double rigid_admittance(const RigidMotion& motion, const Vec3& position, const Vec3& direction) {
  const Vec3 torque = (position - motion.center).cross(direction);
  return 1 / motion.mass + torque.dot(motion.inertia.inverse() * torque);
}

/// Returns the same of the piece as it moves in a substep of `dt` [s]. Microsteps let it move as a rigid one at least.
double admittance(const WorldState& world, const PlacedLoad& grab, const Vec3& direction, double dt) {
  const Body& body = body_at(world, *grab.point);
  if (!body.is_deformable() || world.integrates_explicitly())
    return rigid_admittance(body.motion, grab.spring->position, direction);
  ExternalForces impulse = no_forces(world);
  add_force_at(world, *grab.point, direction, impulse);
  const NodeVectors of_rows = body.system->gather(impulse.nodes, impulse.edges);
  const ImplicitStep step = implicit_step(world, body, dt);
  NodeVectors change =
      respond_alone(deformable_inertia(world, body, dt), of_rows, step.relative_residual, step.max_iterations);
  body.system->project(change);
  return of_rows.cwiseProduct(change).sum();
}

}  // namespace

void update_grab(WorldState& world, double dt) {
  PlacedLoad* placed = present_grab(world);
  if (!placed) return;
  HeldSpring& held = *placed->spring;
  const Vec3 position = position_of(world, *placed->point);
  if (world.time > held.time) held.velocity = (position - held.position) / (world.time - held.time);
  held.position = position;
  held.time = world.time;
  const auto [stiffness, damping, max_force] = spring_constants(world, *placed);
  Vec3& force = placed->load.force;
  const Vec3 pull = stiffness * (held.target - position - dt * held.velocity) - damping * held.velocity;
  const Vec3 change = pull - force;
  if (change.isZero(0)) return;
  const double along = admittance(world, *placed, change.normalized(), dt);
  force += change / (1 + dt * (dt * stiffness + damping) * along);
  if (force.norm() > max_force) force *= max_force / force.norm();
}

}  // namespace griffith
