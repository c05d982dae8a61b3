#include "sim/world/energy/energy_phase.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "sim/core/parallel.h"
#include "sim/solver/pivot.h"
#include "sim/world/bodies/bodies.h"
#include "sim/world/bodies/supported_motion.h"
#include "sim/world/energy/plastic_work.h"
#include "sim/world/motion/turning.h"
#include "sim/world/state/world_state.h"

namespace griffith {
namespace {

/// Linear and angular impulse about a center [N·s], [N·m·s].
struct RigidImpulse {
  Vec3 linear = Vec3::Zero(), angular = Vec3::Zero();
};

/// Returns the impulses of contacts on all objects, per ProxyId; on moving objects about their centers before they
/// move.
std::vector<RigidImpulse> contact_impulses(const WorldState& world) {
  std::vector<Vec3> centers(world.body_of_proxy.size(), Vec3::Zero());
  for (const Body& body : world.bodies) centers[body.proxy] = body.motion.center;
  for (std::size_t i = 0; i < world.projectiles.size(); ++i) {
    const auto object = static_cast<std::size_t>(world.projectiles[i].object.index());
    if (object >= centers.size()) centers.resize(object + 1, Vec3::Zero());
    centers[object] = world.scratch.substep_start.projectiles[i].pose.translation;
  }
  std::vector<RigidImpulse> sums(centers.size());
  const auto add = [&](ProxyId object, const Vec3& place, const Vec3& impulse) {
    const auto index = static_cast<std::size_t>(object.index());
    if (index >= sums.size()) return;  // the ground
    sums[index].linear += impulse;
    sums[index].angular += (place - centers[index]).cross(impulse);
  };
  for (const Contact& contact : world.contact_world.contacts()) {
    add(contact.a, contact.position, contact.impulse);
    add(contact.b, contact.position, -contact.impulse);
  }
  return sums;
}

double twice_turning_energy(const Mat3& inertia, const Vec3& spin) { return spin.dot(inertia * spin); }

/// Accounts for the velocity change of a rigid body by external forces and contacts.
void account_rigid_contacts(WorldState& world, const Body& body, const RigidImpulse& impulse, double dt) {
  const RigidStart& start = world.scratch.bodies[body.id].start;
  const RigidMotion& now = body.motion;
  const double damping = start.falls ? 1 + dt * world.material_of(body).mass_damping : 1;
  const Vec3 pushed = start.velocity + dt / now.mass * start.force;
  const Vec3 turned = start.angular_velocity + dt * (now.inertia.inverse() * start.torque);
  const Vec3 spin = turned / damping + now.inertia.inverse() * impulse.angular;  // before rolling resistance
  const Vec3 mean = 0.5 * (start.velocity + now.velocity), mean_spin = 0.5 * (start.angular_velocity + spin);
  EnergyAccount& energy = world.energy;
  energy.contacts -= impulse.linear.dot(mean) + impulse.angular.dot(mean_spin);
  energy.contacts +=
      0.5 * (twice_turning_energy(now.inertia, spin) - twice_turning_energy(now.inertia, now.angular_velocity));
  energy.material_damping += (1 - 1 / damping) * (now.mass * pushed.dot(mean) + turned.dot(now.inertia * mean_spin));
  const Vec3 load = start.force - (start.falls ? now.mass : 0) * world.model->scene.gravity;
  energy.loads += dt * (load.dot(mean) + start.torque.dot(mean_spin));
}

/// Accounts for the velocity change and the motion of a projectile, made by the contact world.
void account_projectile(WorldState& world, std::size_t index, const RigidImpulse& impulse, double dt) {
  const Projectile& projectile = world.projectiles[index];
  if (world.contact_world.asleep(projectile.object)) return;
  const RigidState& start = world.scratch.substep_start.projectiles[index];
  const RigidState state = world.contact_world.state(projectile.object);
  const Mat3 turn = start.pose.rotation.toRotationMatrix();
  const Mat3 inertia = turn * projectile.inertia * turn.transpose();
  const Vec3 velocity = start.velocity + dt * world.model->scene.gravity + impulse.linear / projectile.mass;
  const Vec3 spin = start.angular_velocity + inertia.inverse() * impulse.angular;
  const Vec3 mean = 0.5 * (start.velocity + velocity), mean_spin = 0.5 * (start.angular_velocity + spin);
  EnergyAccount& energy = world.energy;
  energy.contacts -= impulse.linear.dot(mean) + impulse.angular.dot(mean_spin);
  const double solved = 0.5 * projectile.mass * velocity.squaredNorm() + 0.5 * twice_turning_energy(inertia, spin);
  energy.contacts += solved - kinetic_energy(projectile, state);  // rolling, and what it met on its way
  const Vec3 displacement = state.pose.translation - start.pose.translation;
  const Vec3 pushed_out = world.contact_world.pushed_out(projectile.object);
  energy.limited += projectile.mass * world.model->scene.gravity.dot(pushed_out);
  energy.time_integration += projectile.mass * world.model->scene.gravity.dot(displacement - pushed_out - dt * mean);
}

/// Returns the energy of a change of the stresses of quadratic tets' corners.
double energy_of_quadratic_change(const WorldState& world, const Body& body, const ElasticLaw& law,
                                  const std::vector<Mat3>& stresses) {
  const std::vector<Mat3> now = stresses_of(world, body);
  double sum = 0;
  for (std::size_t i = 0; i < body.tets.size(); ++i) {
    double corners = 0;
    Mat3 total = Mat3::Zero();
    for (std::size_t k = 0; k < 4; ++k) {
      const Mat3 change = now[4 * i + k] - stresses[4 * i + k];
      corners += twice_energy_density(law, change);
      total += change;
    }
    sum += world.elements.rest_elements[body.tets[i]].volume / 40 * (corners + twice_energy_density(law, total));
  }
  return sum;
}

/// Returns the elastic energy of the change of stress, ½ ∫ Δσ : Δε [J]: the excess of the work of sudden loads over the
/// energy that a body stores and the work of yielding.
double energy_of_change(const WorldState& world, const Body& body, const std::vector<Mat3>& stresses) {
  const ElasticLaw law = elastic_law(world.material_of(body));
  if (!body.edges.empty()) return energy_of_quadratic_change(world, body, law, stresses);
  return parallel_sum(static_cast<int>(body.tets.size()), [&](int begin, int end) {
    double sum = 0;
    for (int i = begin; i < end; ++i)
      sum += 0.5 * world.elements.rest_elements[body.tets[i]].volume *
             twice_energy_density(law, world.elements.states[body.tets[i]].stress.full() - stresses[i]);
    return sum;
  });
}

/// Work on the nodes of an elastic body in a substep.
struct NodeWorks {
  double before = 0, predicted = 0, after = 0;  ///< kinetic energy: at the start, before and after the motion [J]
  double change = 0;                            ///< kinetic energy of the change of velocities [J]
  double loads = 0, gravity = 0;                ///< work over the way [J]
  double beside = 0;  ///< work of external forces over what the way lacks of that by the velocities [J]
};

NodeWorks works_of_nodes(const WorldState& world, const Body& body, const BodySnapshot& before,
                         const std::vector<Vec3>& external, double dt) {
  NodeWorks works;
  for (std::size_t i = 0; i < body.nodes.size(); ++i) {
    const NodeId node = body.nodes[i];
    const double mass = world.nodes.masses[node];
    const Vec3 &first = world.scratch.substep_start.velocities[node], &predicted = before.velocities[i];
    const Vec3 displacement = world.nodes.positions[node] - before.positions[i],
               weight = mass * world.model->scene.gravity;
    works.before += 0.5 * mass * first.squaredNorm();
    works.predicted += 0.5 * mass * predicted.squaredNorm();
    works.after += 0.5 * mass * world.nodes.velocities[node].squaredNorm();
    works.change += 0.5 * mass * (predicted - first).squaredNorm();
    works.loads += (external[node] - weight).dot(displacement);
    works.gravity += weight.dot(displacement);
    works.beside += external[node].dot(dt * predicted - displacement);
  }
  for (std::size_t i = 0; i < body.edges.size(); ++i) {
    const EdgeId edge = body.edges[i];
    const double mass = world.edges.masses[edge];
    const Vec3 &first = world.scratch.substep_start.edge_velocities[edge], &predicted = before.edge_velocities[i];
    works.before += 0.5 * mass * first.squaredNorm();
    works.predicted += 0.5 * mass * predicted.squaredNorm();
    works.after += 0.5 * mass * world.edges.velocities[edge].squaredNorm();
    works.change += 0.5 * mass * (predicted - first).squaredNorm();
    const Vec3 &load = world.scratch.edge_loads[edge], displacement = world.edges.offsets[edge] - before.offsets[i];
    works.loads += load.dot(displacement);
    works.beside += load.dot(dt * predicted - displacement);
  }
  return works;
}

}  // namespace

double kinetic_energy(const RigidMotion& motion) {
  return 0.5 * motion.mass * motion.velocity.squaredNorm() +
         0.5 * twice_turning_energy(motion.inertia, motion.angular_velocity);
}

double kinetic_energy(const Projectile& projectile, const RigidState& state) {
  const Vec3 spin = state.pose.rotation.conjugate() * state.angular_velocity;
  return 0.5 * projectile.mass * state.velocity.squaredNorm() + 0.5 * twice_turning_energy(projectile.inertia, spin);
}

double kinetic_energy_of_projectiles(const WorldState& world) {
  double sum = 0;
  for (const Projectile& projectile : world.projectiles)
    sum += kinetic_energy(projectile, world.contact_world.state(projectile.object));
  return sum;
}

void record_substep_start(const WorldState& world, Scratch& scratch) {
  SubstepStart& start = scratch.substep_start;
  start.velocities = world.nodes.velocities;
  start.edge_velocities = world.edges.velocities;
  start.projectiles.clear();
  for (const Projectile& projectile : world.projectiles)
    start.projectiles.push_back(world.contact_world.state(projectile.object));
  scratch.bodies.assign(world.bodies.size(), {});
  for (const Body& body : world.bodies) {
    RigidStart& of_body = scratch.bodies[body.id].start;
    of_body = {body.motion.velocity, body.motion.angular_velocity};
    of_body.rigid = body.rigid;
  }
}

void account_rigid_contacts(WorldState& world, double dt) {
  const std::vector<RigidImpulse> impulses = contact_impulses(world);
  for (const Body& body : world.bodies)
    if (body.rigid && !body.asleep && !body.explicit_state && !body.supported())
      account_rigid_contacts(world, body, impulses[body.proxy], dt);
  for (std::size_t i = 0; i < world.projectiles.size(); ++i)
    account_projectile(world, i, impulses[world.projectiles[i].object], dt);
}

BodySnapshot snapshot(const WorldState& world, const Body& body) {
  BodySnapshot taken;
  taken.positions.reserve(body.nodes.size());
  taken.velocities.reserve(body.nodes.size());
  for (NodeId node : body.nodes) {
    taken.positions.push_back(world.nodes.positions[node]);
    taken.velocities.push_back(world.nodes.velocities[node]);
  }
  for (EdgeId edge : body.edges) {
    taken.offsets.push_back(world.edges.offsets[edge]);
    taken.edge_velocities.push_back(world.edges.velocities[edge]);
  }
  if (!world.material_of(body).yield_strength) return taken;
  for (TetId tet : body.tets)
    body.edges.empty() ? taken.plastic_strains.push_back(world.elements.plastic_strains[tet])
                       : taken.point_strains.push_back(world.elements.point_strains[tet]);
  return taken;
}

void restore_plastic_strains(WorldState& world, const Body& body, const BodySnapshot& taken) {
  for (std::size_t i = 0; i < taken.plastic_strains.size(); ++i)
    world.elements.plastic_strains[body.tets[i]] = taken.plastic_strains[i];
  for (std::size_t i = 0; i < taken.point_strains.size(); ++i)
    world.elements.point_strains[body.tets[i]] = taken.point_strains[i];
}

namespace {

/// Pivot of a body's rotation in the implicit step, and its spin by momentum balance [rad/s].
struct SpinInStep {
  Vec3 place = Vec3::Zero(), spin = Vec3::Zero();
};

/// Returns no spin if supports prevent rotation.
SpinInStep spin_in_step(const WorldState& world, const Body& body, const BodySnapshot& before,
                        const std::vector<Vec3>& external, double dt) {
  std::optional<Pivot> pivot;
  if (body.supported()) {
    pivot = pivot_of(world, body);
    if (!pivot) return {};
  }
  const auto count = static_cast<Eigen::Index>(body.nodes.size());
  NodeVectors positions(3, count), velocities(3, count);
  Eigen::VectorXd masses(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const NodeId node = body.nodes[i];
    masses[i] = world.nodes.masses[node];
    positions.col(i) = before.positions[i];
    velocities.col(i) = world.scratch.substep_start.velocities[node] + dt / masses[i] * external[node];
  }
  velocities /= 1 + dt * world.material_of(body).mass_damping;
  if (pivot) return {pivot->place, turning_about(*pivot, positions, velocities, masses).spin};
  const RigidMotion motion = rigid_motion(positions, velocities, masses);
  return {motion.center, motion.angular_velocity};
}

/// Returns the work of the centrifugal impulses of the implicit step [J]. The step deforms the body in axes that rotate
/// with it by momentum balance before contacts; these impulses do not act on the rotation (ElasticSystem::solve()).
double centrifugal_work(const WorldState& world, const Body& body, const BodySnapshot& before,
                        const std::vector<Vec3>& external, double dt) {
  const auto [place, spin] = spin_in_step(world, body, before, external, dt);
  double work = 0;
  for (std::size_t i = 0; i < body.nodes.size(); ++i) {
    const Vec3 arm = before.positions[i] - place;
    const NodeId node = body.nodes[i];
    const Vec3& deforming = world.scratch.substep_start.deforming_velocities[node];
    work += dt * world.nodes.masses[node] * spin.cross(arm.cross(spin)).dot(deforming);
  }
  return work;
}

/// Returns the work of the torque by which external forces act on a body that swings about a pivot in the middle of the
/// substep, not at its start [J].
double work_gained_halfway(const WorldState& world, const Body& body, const BodySnapshot& before,
                           const std::vector<Vec3>& external, double dt) {
  const std::optional<Pivot> pivot = body.supported() ? pivot_of(world, body) : std::nullopt;
  if (!pivot) return 0;
  NodeVectors positions(3, static_cast<Eigen::Index>(body.nodes.size()));
  for (std::size_t i = 0; i < body.nodes.size(); ++i) positions.col(static_cast<Eigen::Index>(i)) = before.positions[i];
  const Vec3 change =
      acceleration_gained_halfway(*pivot, positions, of_nodes(body, world.scratch.substep_start.velocities),
                                  masses_of(world, body), of_nodes(body, external), dt);
  double work = 0;
  for (std::size_t i = 0; i < body.nodes.size(); ++i)
    work += dt * world.nodes.masses[body.nodes[i]] *
            change.cross(before.positions[i] - pivot->place).dot(before.velocities[i]);
  return work;
}

}  // namespace

EnergyAccount spent_in_move(const WorldState& world, const Body& body, const BodySnapshot& before,
                            const ElasticWorks& elastic, const std::vector<Vec3>& external, double dt,
                            ElasticMove move) {
  const Material& material = world.material_of(body);
  const NodeWorks nodes = works_of_nodes(world, body, before, external, dt);
  const double stored = stored_since(world, body, elastic);
  const BodyStep& step = world.scratch.bodies[body.id];
  EnergyAccount spent;
  spent.loads = world.loads.empty() ? 0 : nodes.loads;
  for (NodeId node : body.system->supports())
    spent.supports += dt * world.nodes.reactions[node].dot(world.nodes.constraints[node].velocity);
  spent.plastic = plastic_work(world, body, before);
  spent.material_damping = 2 * dt * material.mass_damping * nodes.predicted;
  if (move == ElasticMove::linearized)  // of a nonlinear step, part of what time integration takes
    spent.material_damping += material.stiffness_damping / dt * elastic.change;
  if (move != ElasticMove::linearized) {
    spent.time_integration = nodes.before + spent.loads + nodes.gravity + spent.supports + step.contact_work -
                             nodes.after - stored - spent.plastic - spent.material_damping;
  } else {
    const double forces = (step.start.rigid ? 0 : elastic.first) + (world.integrates_explicitly() ? 0 : elastic.change);
    spent.time_integration =
        nodes.change + nodes.predicted - nodes.after - nodes.beside + forces - stored - spent.plastic;
    if (!step.start.rigid && !world.integrates_explicitly())
      spent.time_integration -=
          centrifugal_work(world, body, before, external, dt) + work_gained_halfway(world, body, before, external, dt);
  }
  return spent;
}

EnergyAccount spent_in_equilibrium(const WorldState& world, const Body& body, const BodySnapshot& before,
                                   const std::vector<Mat3>& stresses, double displacement_time) {
  EnergyAccount spent;
  spent.time_integration = energy_of_change(world, body, stresses);
  spent.plastic = work_of_yielding(world, body, before, 0);
  for (NodeId node : body.system->supports())
    spent.supports += displacement_time * world.nodes.reactions[node].dot(world.nodes.constraints[node].velocity);
  if (world.loads.empty()) return spent;
  ExternalForces loads = no_forces(world);
  add_load_forces(world, world.time, loads);
  for (std::size_t i = 0; i < body.nodes.size(); ++i)
    spent.loads += loads.nodes[body.nodes[i]].dot(world.nodes.positions[body.nodes[i]] - before.positions[i]);
  for (std::size_t i = 0; i < body.edges.size(); ++i)
    spent.loads += loads.edges[body.edges[i]].dot(world.edges.offsets[body.edges[i]] - before.offsets[i]);
  return spent;
}

EnergyAccount spent_in_rigid_move(const WorldState& world, const Body& body, const RigidMotion& before, double dt) {
  const RigidMotion& after = body.motion;
  const RigidStart& start = world.scratch.bodies[body.id].start;
  const Vec3 mean = 0.5 * (start.velocity + before.velocity);
  const Vec3 beside = after.center - before.center - (start.falls ? dt : 0) * mean;
  EnergyAccount spent;
  spent.time_integration =
      kinetic_energy(before) - kinetic_energy(after) + before.mass * world.model->scene.gravity.dot(beside);
  return spent;
}

ObstacleAccount::Kept ObstacleAccount::kept_by(const WorldState& world, const explicit_dynamics::Obstacle& obstacle) {
  if (!obstacle.object.valid() || !obstacle.is_movable()) return {};
  if (const BodyId id = world.body_of(obstacle.object); id.valid()) {
    const Body& body = world.bodies[id];
    return {energy_of(world, body), body.motion.mass, body.motion.center};
  }
  for (const Projectile& projectile : world.projectiles)
    if (projectile.object == obstacle.object) {
      const RigidState state = world.contact_world.state(projectile.object);
      return {kinetic_energy(projectile, state), projectile.mass, state.pose.translation};
    }
  return {};
}

ObstacleAccount::ObstacleAccount(const WorldState& world, std::span<const explicit_dynamics::Obstacle> obstacles) {
  for (const explicit_dynamics::Obstacle& obstacle : obstacles) before_.push_back(kept_by(world, obstacle));
}

void ObstacleAccount::record(WorldState& world, std::span<const explicit_dynamics::Obstacle> obstacles) const {
  for (std::size_t i = 0; i < obstacles.size(); ++i) {
    if (!std::isfinite(obstacles[i].energy_gained)) continue;
    if (!obstacles[i].is_movable()) {
      world.energy.supports -= obstacles[i].energy_gained;  // what drives it does not slow down
      continue;
    }
    const Kept after = kept_by(world, obstacles[i]);
    world.energy.regime_change += before_[i].energy + obstacles[i].energy_gained - after.energy;
    world.energy.time_integration += after.mass * world.model->scene.gravity.dot(after.center - before_[i].center);
  }
}

}  // namespace griffith
