#include "sim/world/explicit/explicit_obstacles.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <limits>
#include <optional>

#include "sim/core/rotation.h"
#include "sim/world/bodies/bodies.h"
#include "sim/world/bodies/supported_motion.h"
#include "sim/world/motion/elastic_phase.h"
#include "sim/world/motion/turning.h"
#include "sim/world/regime/regime_change.h"

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

/// Returns the collision parts of a body about the origin of an obstacle's frame, in which it has this `center` [m].
std::vector<ConvexPart> parts_about_origin(const Body& body, const Vec3& center) {
  std::vector<ConvexPart> parts = body.collision_parts;
  for (ConvexPart& part : parts)
    for (Vec3& corner : part) corner += center;
  return parts;
}

std::vector<explicit_dynamics::ConvexSolid> solids_of(const std::vector<ConvexPart>& parts, double spacing) {
  std::vector<explicit_dynamics::ConvexSolid> solids;
  for (const ConvexPart& part : parts) solids.push_back(explicit_dynamics::convex_solid(convex_hull(part), spacing));
  return solids;
}

/// Surroundings of the bodies in explicit dynamics, and the resolution of their surface.
struct Surroundings {
  struct Reach {
    Eigen::AlignedBox3d box;
    int family = 0;  ///< index of the scene body
  };
  std::vector<Reach> reaches;
  double element_size = std::numeric_limits<double>::infinity();

  /// True if a sphere may meet bodies of other families than its own.
  bool may_meet(const Vec3& center, double radius, int family = -1) const {
    return std::ranges::any_of(reaches, [&](const Reach& reach) {
      return reach.family != family && reach.box.exteriorDistance(center) <= radius;
    });
  }
};

double radius_of(const std::vector<ConvexPart>& parts) {
  double radius = 0;
  for (const ConvexPart& part : parts)
    for (const Vec3& corner : part) radius = std::max(radius, corner.norm());
  return radius;
}

void add_projectiles(const WorldState& world, const Surroundings& near, double duration,
                     std::vector<explicit_dynamics::Obstacle>& obstacles) {
  for (const Projectile& projectile : world.projectiles) {
    const RigidState state = world.contact_world.state(projectile.object);
    if (near.may_meet(state.pose.translation, projectile.radius + duration * state.velocity.norm()))
      obstacles.push_back(obstacle_of(world, projectile, near.element_size));
  }
}

void add_bodies(const WorldState& world, const Surroundings& near, double duration,
                std::vector<explicit_dynamics::Obstacle>& obstacles) {
  for (const Body& body : world.bodies) {
    if (body.explicit_state) continue;
    const double radius = radius_of(body.collision_parts),
                 speed = body.motion.velocity.norm() + radius * body.motion.angular_velocity.norm();
    if (!near.may_meet(body.motion.center, radius + duration * speed, body.scene_body)) continue;
    obstacles.push_back(obstacle_of(world, body, proxy_state(world, body), near.element_size));
    obstacles.back().family = body.scene_body;  // pieces of one body touch as rigid ones afterwards
  }
}

/// Carries a deformable body, and finds its state there.
void carry_nodes(WorldState& world, Body& body, const Mat3& turn, const RigidState& before, const RigidState& after) {
  carry(world, body, turn, before, after);
  update_elements(world, body);
  update_motion(world, body);
}

/// Returns the pivot about which contacts can swing a body.
std::optional<Pivot> swinging_pivot_of(const WorldState& world, const Body& body) {
  if (!body.supported() || !body.is_deformable()) return std::nullopt;
  return pivot_of(world, body);
}

/// Lets an obstacle swing about the pivot of its body.
void set_pivot(const WorldState& world, const Body& body, const Pivot& pivot, explicit_dynamics::Obstacle& obstacle) {
  const Mat3 back = body.orientation.conjugate().toRotationMatrix();
  const Pivot::Axes axes = back * pivot.axes;
  obstacle.state.pose.translation = pivot.place;
  obstacle.state.velocity.setZero();
  obstacle.center = back * (body.motion.center - pivot.place);
  obstacle.inverse_inertia =
      axes * inverse_inertia_on_axes(pivot, turning_of(world, body, pivot).inertia) * axes.transpose();
}

/// Swings a body about its pivot to the state of its obstacle.
void swing_body(WorldState& world, Body& body, const RigidState& state) {
  const std::optional<Pivot> pivot = swinging_pivot_of(world, body);
  if (!pivot) return;
  const Eigen::AngleAxisd turned(state.pose.rotation * body.orientation.conjugate());
  const Vec3 about_axes = pivot->axes * (pivot->axes.transpose() * (turned.angle() * turned.axis()));
  const RigidState before{{pivot->place, body.orientation}, Vec3::Zero(), turning_of(world, body, *pivot).spin};
  carry_nodes(world, body, rotation_by(about_axes).toRotationMatrix(), before, state);
}

}  // namespace

std::vector<explicit_dynamics::Obstacle> reachable_obstacles(const WorldState& world, double duration) {
  Surroundings near;
  for (const Body& body : world.bodies) {
    if (!body.explicit_state) continue;
    near.reaches.push_back({reach_of(world, body, duration), body.scene_body});
    near.element_size = std::min(near.element_size, body.element_size);
  }
  if (near.reaches.empty()) return {};
  std::vector<explicit_dynamics::Obstacle> obstacles;
  add_ground(world, obstacles);
  add_projectiles(world, near, duration, obstacles);
  add_bodies(world, near, duration, obstacles);
  return obstacles;
}

void add_ground(const WorldState& world, std::vector<explicit_dynamics::Obstacle>& obstacles) {
  if (!world.model->scene.ground) return;
  explicit_dynamics::Obstacle ground;
  ground.radius = std::numeric_limits<double>::infinity();
  ground.solids = {{{{Vec3::UnitY(), world.model->scene.ground->height}}, {}, {}}};
  ground.friction = world.model->scene.ground->friction;
  obstacles.push_back(ground);
}

explicit_dynamics::Obstacle obstacle_of(const WorldState& world, const Projectile& projectile, double spacing) {
  explicit_dynamics::Obstacle obstacle;
  obstacle.object = projectile.object;
  obstacle.state = world.contact_world.state(projectile.object);
  obstacle.radius = projectile.radius;
  if (projectile.hull) obstacle.solids = {explicit_dynamics::convex_solid(*projectile.hull, spacing)};
  obstacle.inverse_mass = 1 / projectile.mass;
  obstacle.inverse_inertia = projectile.inertia.inverse();
  obstacle.friction = projectile.surface.friction;
  return obstacle;
}

explicit_dynamics::Obstacle obstacle_of(const WorldState& world, const Body& body, const RigidState& state,
                                        double spacing) {
  explicit_dynamics::Obstacle obstacle;
  obstacle.object = body.proxy;
  obstacle.friction = world.material_of(body).friction;
  obstacle.is_soft = deforms_visibly(world, body);
  obstacle.state = state;
  if (!body.supported()) {
    obstacle.inverse_mass = 1 / body.motion.mass;
    const Mat3 back = body.orientation.conjugate().toRotationMatrix();
    obstacle.inverse_inertia = back * body.motion.inertia.inverse() * back.transpose();
  } else if (const std::optional<Pivot> pivot = swinging_pivot_of(world, body)) {
    set_pivot(world, body, *pivot, obstacle);
  } else if (!is_driven(world, body)) {
    obstacle.state = {{body.motion.center, body.orientation}};
  }
  const std::vector<ConvexPart> parts = parts_about_origin(body, obstacle.center);
  obstacle.radius = radius_of(parts);
  obstacle.solids = solids_of(parts, spacing);
  return obstacle;
}

void read_back_velocities(const WorldState& world, std::vector<explicit_dynamics::Obstacle>& obstacles) {
  for (explicit_dynamics::Obstacle& obstacle : obstacles) {
    if (!obstacle.object.valid() || !obstacle.is_movable()) continue;
    const BodyId id = world.body_of(obstacle.object);
    if (!id.valid()) {
      const RigidState state = world.contact_world.state(obstacle.object);
      obstacle.state.velocity = state.velocity;
      obstacle.state.angular_velocity = state.angular_velocity;
    } else if (const std::optional<Pivot> pivot = swinging_pivot_of(world, world.bodies[id])) {
      obstacle.state.angular_velocity = turning_of(world, world.bodies[id], *pivot).spin;
    } else if (!world.bodies[id].supported()) {
      obstacle.state.velocity = world.bodies[id].motion.velocity;
      obstacle.state.angular_velocity = world.bodies[id].motion.angular_velocity;
    }
  }
}

void place_body(WorldState& world, Body& body, const RigidState& state) {
  const Mat3 turn = (state.pose.rotation * body.orientation.conjugate()).toRotationMatrix();
  const RigidMotion& motion = body.motion;
  if (!body.rigid) {
    const RigidState before{{motion.center, body.orientation}, motion.velocity, motion.angular_velocity};
    return carry_nodes(world, body, turn, before, state);
  }
  body.motion.center = state.pose.translation;
  body.motion.inertia = turn * body.motion.inertia * turn.transpose();
  body.motion.velocity = state.velocity;
  body.motion.angular_velocity = state.angular_velocity;
  body.orientation = state.pose.rotation;
  place_rigid_nodes(body, world.nodes, world.edges);
}

void place_obstacle(WorldState& world, const explicit_dynamics::Obstacle& obstacle) {
  const RigidState& state = obstacle.state;
  if (!obstacle.object.valid() || !obstacle.is_movable()) return;
  if (!obstacle.was_pushed) return;  // the substep has moved it, among contacts that microsteps do not know
  if (!state.pose.translation.allFinite() || !state.velocity.allFinite() || !state.angular_velocity.allFinite()) return;
  const BodyId id = world.body_of(obstacle.object);
  if (obstacle.inverse_mass == 0) return swing_body(world, world.bodies[id], state);
  world.contact_world.set_state(obstacle.object, state);
  if (id.valid()) place_body(world, world.bodies[id], state);
}

}  // namespace griffith
