#include "sim/world/shock/shock_phase.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <limits>

#include "sim/world/bodies/bodies.h"
#include "sim/world/conditions/quick_changes.h"
#include "sim/world/energy/energy_phase.h"
#include "sim/world/phases/cracking.h"
#include "sim/world/phases/elastic_phase.h"
#include "sim/world/phases/expected_impacts.h"
#include "sim/world/phases/motion_phase.h"
#include "sim/world/phases/separation_phase.h"
#include "sim/world/shock/shock_run.h"
#include "sim/world/shock/similarity.h"
#include "sim/world/world_state.h"

namespace griffith {
namespace {

Eigen::AlignedBox3d reach_of(const WorldState& world, const Body& body, double duration) {
  Eigen::AlignedBox3d box;
  for (const NodeId node : body.nodes) {
    box.extend(world.nodes.positions[node]);
    box.extend(world.nodes.positions[node] + duration * world.nodes.velocities[node]);
  }
  return box;
}

std::vector<shock::ConvexSolid> solids_of(const std::vector<ConvexPart>& parts, double spacing) {
  std::vector<shock::ConvexSolid> solids;
  for (const ConvexPart& part : parts) solids.push_back(shock::convex_solid(convex_hull(part), spacing));
  return solids;
}

/// What surrounds the bodies in shock, and how fine their surface is.
struct Surroundings {
  std::vector<Eigen::AlignedBox3d> boxes;
  double element_size = std::numeric_limits<double>::infinity();

  std::vector<std::uint8_t> own;  ///< per scene body: 1 where pieces of it are in shock

  bool may_meet(const Vec3& center, double reach) const {
    return std::ranges::any_of(boxes, [&](const auto& box) { return box.exteriorDistance(center) <= reach; });
  }
};

double radius_of(const Body& body) {
  double radius = 0;
  for (const ConvexPart& part : body.collision_parts)
    for (const Vec3& corner : part) radius = std::max(radius, corner.norm());
  return radius;
}

void add_ground(const WorldState& world, std::vector<shock::Obstacle>& obstacles) {
  if (!world.model->scene.ground) return;
  shock::Obstacle ground;
  ground.radius = std::numeric_limits<double>::infinity();
  ground.solids = {{{{Vec3::UnitY(), world.model->scene.ground->height}}, {}}};
  ground.friction = world.model->scene.ground->friction;
  obstacles.push_back(ground);
}

void add_projectiles(const WorldState& world, const Surroundings& near, double duration,
                     std::vector<shock::Obstacle>& obstacles) {
  for (const Projectile& projectile : world.projectiles) {
    shock::Obstacle obstacle;
    obstacle.object = projectile.object;
    obstacle.state = world.contact_world.state(projectile.object);
    obstacle.radius = projectile.radius;
    if (!near.may_meet(obstacle.state.pose.translation, projectile.radius + duration * obstacle.state.velocity.norm()))
      continue;
    if (projectile.hull) obstacle.solids = {shock::convex_solid(*projectile.hull, near.element_size)};
    obstacle.inverse_mass = 1 / projectile.mass;
    obstacle.inverse_inertia = projectile.inertia.inverse();
    obstacle.friction = projectile.surface.friction;
    obstacles.push_back(obstacle);
  }
}

void add_bodies(const WorldState& world, const Surroundings& near, double duration,
                std::vector<shock::Obstacle>& obstacles) {
  for (const Body& body : world.bodies) {
    if (body.shock || near.own[body.scene_body]) continue;  // pieces of one body touch as rigid ones afterwards
    shock::Obstacle obstacle;
    obstacle.object = body.proxy;
    obstacle.radius = radius_of(body);
    obstacle.state = {{body.motion.center, body.orientation}, body.motion.velocity, body.motion.angular_velocity};
    const double displacement =
        duration * (body.motion.velocity.norm() + obstacle.radius * body.motion.angular_velocity.norm());
    if (!near.may_meet(body.motion.center, obstacle.radius + displacement)) continue;
    obstacle.solids = solids_of(body.collision_parts, near.element_size);
    if (!body.supported()) {
      obstacle.inverse_mass = 1 / body.motion.mass;
      const Mat3 back = body.orientation.conjugate().toRotationMatrix();
      obstacle.inverse_inertia = back * body.motion.inertia.inverse() * back.transpose();
    } else {
      obstacle.state.velocity = obstacle.state.angular_velocity = Vec3::Zero();
    }
    obstacle.friction = world.material_of(body).friction;
    obstacles.push_back(obstacle);
  }
}

/// The velocities that things around have now, before the microsteps.
void read_back_velocities(const WorldState& world, std::vector<shock::Obstacle>& obstacles) {
  for (shock::Obstacle& obstacle : obstacles) {
    if (!obstacle.object.valid() || obstacle.inverse_mass == 0) continue;
    const BodyId id = world.body_of(obstacle.object);
    if (!id.valid()) {
      const RigidState state = world.contact_world.state(obstacle.object);
      obstacle.state.velocity = state.velocity;
      obstacle.state.angular_velocity = state.angular_velocity;
    } else {
      obstacle.state.velocity = world.bodies[id].motion.velocity;
      obstacle.state.angular_velocity = world.bodies[id].motion.angular_velocity;
    }
  }
}

/// A body that sways is moved and turned as a whole to where the microsteps have brought its proxy.
void carry_nodes(WorldState& world, Body& body, const RigidState& state) {
  const Mat3 turn = (state.pose.rotation * body.orientation.conjugate()).toRotationMatrix();
  const RigidMotion before = body.motion;
  const Vec3 velocity = state.velocity - before.velocity, spin = state.angular_velocity - before.angular_velocity;
  for (const NodeId node : body.nodes) {
    const Vec3 arm = world.nodes.positions[node] - before.center;
    world.nodes.velocities[node] += velocity + spin.cross(arm);
    world.nodes.positions[node] = state.pose.translation + turn * arm;
    world.nodes.velocities[node] = turn * (world.nodes.velocities[node] - state.velocity) + state.velocity;
  }
  for (const EdgeId edge : body.edges) {
    Vec3 &offset = world.edges.offsets[edge], &bending = world.edges.velocities[edge];
    bending = turn * (bending + spin.cross(offset));
    offset = (turn * offset).eval();
  }
  update_elements(world, body);
  update_motion(world, body);
}

void place_obstacle(WorldState& world, const shock::Obstacle& obstacle) {
  const RigidState& state = obstacle.state;
  if (!obstacle.object.valid() || obstacle.inverse_mass == 0) return;
  if (!state.pose.translation.allFinite() || !state.velocity.allFinite() || !state.angular_velocity.allFinite()) return;
  world.contact_world.set_state(obstacle.object, obstacle.state);
  const BodyId id = world.body_of(obstacle.object);
  if (!id.valid()) return;
  Body& body = world.bodies[id];
  if (!body.rigid) return carry_nodes(world, body, obstacle.state);
  const Mat3 turn = (obstacle.state.pose.rotation * body.orientation.conjugate()).toRotationMatrix();
  body.motion.center = obstacle.state.pose.translation;
  body.motion.inertia = turn * body.motion.inertia * turn.transpose();
  body.motion.velocity = obstacle.state.velocity;
  body.motion.angular_velocity = obstacle.state.angular_velocity;
  body.orientation = obstacle.state.pose.rotation;
  place_rigid_nodes(world, body);
}

}  // namespace

bool in_shock(const WorldState& world) {
  return std::ranges::any_of(world.bodies, [](const Body& body) { return body.shock.has_value(); });
}

void enter_shock(WorldState& world, Body& body, double impact_speed) {
  if (body.shock || body.tets.size() == 1) return;
  if (body.rigid) place_rigid_nodes(world, body);
  if (body.rigid || body.asleep) make_elastic(world, body);
  world.elements.allow_strains();
  for (const NodeId node : body.nodes) world.nodes.overloads[node].last = OverloadHistory::kNever;
  if (impact_speed > 0) ++world.report.impacts;
  body.shock = Shock{world.time, impact_speed, highest_frequency(world, body)};
}

namespace {

/// Whether two pieces of one body have just parted: what they do to each other then is no blow.
bool have_just_parted(const WorldState& world, BodyId a, BodyId b) {
  constexpr double kApart = 0.1;  // [s]
  if (!a.valid() || !b.valid() || world.bodies[a].scene_body != world.bodies[b].scene_body) return false;
  return world.bodies[a].shock || world.bodies[b].shock ||
         world.time - std::max(world.bodies[a].shock_ended, world.bodies[b].shock_ended) < kApart;
}

/// Whether a body is one for microsteps, struck at this speed [m/s]: their elements stand no large strains, nor large
/// turns in a microstep. What is soft, or spins nearly as fast as its waves run, or has elements so small or flat that
/// a wave crosses many others in a microstep of theirs, is left to the implicit step.
bool suits_microsteps(const WorldState& world, const Body& body, double impact_speed) {
  constexpr double kMaxStrain = 0.05, kMaxMach = 0.3;
  constexpr double kMaxFrequency = 200;  // in bar wave speeds over the mean edge length
  const Material& material = world.material_of(body);
  const double wave_speed = bar_wave_speed(material);
  return material.tensile_strength < kMaxStrain * material.young_modulus &&
         std::max(impact_speed, inner_speed(world, body)) < kMaxMach * wave_speed &&
         highest_frequency(world, body) * body.element_size < kMaxFrequency * wave_speed;
}

/// Whether a body that strikes another, and is not hurt itself, must deform too: as a rigid one it would strike up to
/// twice as hard. In one that is much heavier, waves spread so far that it hardly gives way.
bool yields_now(const WorldState& world, const Body& body, const Body& struck, double impact_speed) {
  constexpr double kMuchHeavier = 8;
  return body.motion.mass < kMuchHeavier * struck.motion.mass && suits_microsteps(world, body, impact_speed);
}

/// Whether a body is to enter when it is struck at this speed [m/s].
bool is_hurt_by(const WorldState& world, BodyId struck, double approach) {
  return struck.valid() && approach >= damage_speed(world, world.bodies[struck]) &&
         suits_microsteps(world, world.bodies[struck], approach);
}

/// Whether a body is to enter for it.
bool is_blow(const WorldState& world, const ContactWorld::Encounter& impact) {
  return is_hurt_by(world, world.body_of(impact.a), impact.approach) ||
         is_hurt_by(world, world.body_of(impact.b), impact.approach);
}

/// What else strikes, debris mostly, is caught by the implicit step.
double time_before_blow(const WorldState& world, double maximum) {
  const auto matters = [&](BodyId a, BodyId b) { return !have_just_parted(world, a, b); };
  std::vector<ContactWorld::Encounter> blows = expected_impacts(world, maximum, matters);
  std::erase_if(blows, [&](const auto& impact) { return !is_blow(world, impact); });
  return time_before(blows, maximum);
}

/// Lets the bodies enter that something will strike hard enough to hurt within `duration` [s].
void enter_struck_bodies(WorldState& world, double duration) {
  const auto may_enter = [&](BodyId id) { return id.valid() && !world.bodies[id].shock; };
  const auto matters = [&](BodyId a, BodyId b) {
    return (may_enter(a) || may_enter(b)) && !have_just_parted(world, a, b);
  };
  for (const auto& [a, b, approach, time] : expected_impacts(world, duration, matters)) {
    const BodyId first = world.body_of(a), second = world.body_of(b);
    if (have_just_parted(world, first, second)) continue;  // one of the two has entered by now
    for (const auto& [struck, other] : {std::pair(first, second), std::pair(second, first)}) {
      if (!is_hurt_by(world, struck, approach)) continue;
      enter_shock(world, world.bodies[struck], approach);
      if (other.valid() && yields_now(world, world.bodies[other], world.bodies[struck], approach))
        enter_shock(world, world.bodies[other], approach);
    }
  }
}

/// Quick changes of what acts on bodies for microsteps within `duration` [s].
std::vector<QuickChange> changes_for_microsteps(const WorldState& world, double duration) {
  constexpr double kRounding = 1e-9;
  const double now = world.time, past = kRounding * world.model->scene.simulation.time_step;
  std::vector<QuickChange> changes = quick_changes(world, {now - past, now + duration});
  std::erase_if(changes, [&](const QuickChange& change) {
    const Body& body = world.bodies[change.body];
    return !body.shock && !suits_microsteps(world, body, 0);
  });
  return changes;
}

double time_before_change(const WorldState& world, double maximum) {
  double time = maximum;
  for (const QuickChange& change : changes_for_microsteps(world, maximum))
    time = std::min(time, std::max(0.0, change.time.from - world.time));
  return time;
}

/// Lets the bodies enter in which loads and supports make waves within `duration` [s], which they follow from then on.
void enter_driven_bodies(WorldState& world, double duration) {
  for (const QuickChange& change : changes_for_microsteps(world, duration)) {
    Body& body = world.bodies[change.body];
    enter_shock(world, body, 0);
    if (body.shock)
      body.shock->last_event = std::max(body.shock->last_event, std::min(change.time.to, world.time + duration));
  }
}

/// Lets a free piece move as a whole: what still vibrates in it is damped at once.
void stop_vibration(WorldState& world, Body& body) {
  const double before = energy_of(world, body);
  clear_stress(world, body);
  make_rigid(world, body);
  world.energy.hand_over += before - energy_of(world, body);
}

/// A piece that waves have crossed without harm moves as a whole from now on, until something strikes it: what still
/// vibrates in it is damped at once.
void make_rigid_if_unharmed(WorldState& world, Body& body) {
  constexpr double kUnharmed = 0.25;  // of the resistance: what contacts must exceed to make it elastic again
  evaluate_separation(world, body);
  const auto is_unharmed = [&](NodeId node) { return world.nodes.separations[node].utilization < kUnharmed; };
  if (std::ranges::all_of(body.nodes, is_unharmed)) stop_vibration(world, body);
}

/// Leaves the rest of the step to the implicit one.
void cut_shocks_short(WorldState& world) {
  for (Body& body : world.bodies) {
    if (!body.shock) continue;
    end_shock(world, body);
    ++world.report.unfinished_shocks;
    if (!body.supported()) stop_vibration(world, body);
  }
}

}  // namespace

double next_stretch(WorldState& world, double left) {
  if (!in_shock(world)) {
    world.shock_overhead = 1;
    const double calm = std::min(time_before_blow(world, left), time_before_change(world, left));
    if (calm > impact_tolerance(world) || calm == left) return calm;
  }
  if (is_spent(world)) {
    cut_shocks_short(world);
    return left;
  }
  const double stretch = stretch_of_shock(world, left);
  enter_struck_bodies(world, stretch);
  enter_driven_bodies(world, stretch);
  if (!in_shock(world)) return left;
  for (Body& body : world.bodies)
    if (body.shock) limit_frequency(world, body);
  choose_similarity(world, left);
  return stretch_of_shock(world, left);
}

void enter_overloaded_bodies(WorldState& world) {
  if (!world.model->scene.simulation.fracture || is_spent(world)) return;
  for (Body& body : world.bodies) {
    const auto is_overloaded = [&](NodeId node) {
      return world.nodes.separations[node].utilization > 1 && may_crack(world, node);
    };
    if (body.sways() && std::ranges::any_of(body.nodes, is_overloaded) && suits_microsteps(world, body, 0))
      enter_shock(world, body, 0);
  }
}

std::vector<shock::Obstacle> obstacles_of_shock(const WorldState& world, double duration) {
  if (!in_shock(world)) return {};
  Surroundings near;
  near.own.resize(world.model->scene.bodies.size(), 0);
  for (const Body& body : world.bodies) {
    if (!body.shock) continue;
    near.own[body.scene_body] = 1;
    near.boxes.push_back(reach_of(world, body, duration));
    near.element_size = std::min(near.element_size, body.element_size);
  }
  std::vector<shock::Obstacle> obstacles;
  add_ground(world, obstacles);
  add_projectiles(world, near, duration, obstacles);
  add_bodies(world, near, duration, obstacles);
  return obstacles;
}

void end_shock(WorldState& world, Body& body) {
  end_similarity(world, body);
  body.shock.reset();
  body.shock_ended = world.time;
}

bool run_shock(WorldState& world, std::vector<shock::Obstacle> obstacles, double duration, double max_work) {
  read_back_velocities(world, obstacles);
  const ObstacleAccount account(world, obstacles);
  ShockRun run(world, std::move(obstacles));
  if (!run.run(duration, max_work)) return false;
  for (const shock::Obstacle& obstacle : run.obstacles()) place_obstacle(world, obstacle);
  account.book(world, run.obstacles());
  run.finish(duration);
  return true;
}

void leave_shock(WorldState& world) {
  constexpr double kRounding = 1e-9;
  const std::vector<bool> strained = strained_bodies(world, world.time);
  for (Body& body : world.bodies) {
    if (!body.shock) continue;
    const double window = shock_window(world, body);
    if (world.time - body.shock->last_event < (1 - kRounding) * window) continue;
    end_shock(world, body);
    if (!body.supported() && !strained[body.id]) make_rigid_if_unharmed(world, body);
  }
}

}  // namespace griffith
