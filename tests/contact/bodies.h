#pragma once

// Bodies and owners for the contact tests.

#include <array>
#include <random>
#include <vector>

#include "sim/contact/contact_world.h"

namespace griffith::testing {

inline constexpr double kDt = 1.0 / 120;  // of a substep [s]

/// A box around its center.
inline ConvexPart box_part(const Vec3& size) {
  ConvexPart corners;
  for (int i = 0; i < 8; ++i)
    corners.push_back(0.5 * size.cwiseProduct(Vec3(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1)));
  return corners;
}

inline std::vector<ConvexPart> box_parts(const Vec3& size) { return {box_part(size)}; }

inline RigidMass box_mass(const Vec3& size, double mass) {
  const Vec3 squares = size.cwiseProduct(size);
  return {mass, (mass / 12 * (squares.sum() - squares.array())).matrix().asDiagonal()};
}

/// Moves a proxy as a rigid body: what the elastic solve does, without elasticity.
inline void advance(ContactWorld& world, ProxyId proxy, double dt) {
  RigidState state = world.state(proxy);
  const auto correction = world.position_correction(proxy);
  state.pose.translation += dt * state.velocity + correction.translation;
  const Vec3 turn = dt * state.angular_velocity + correction.rotation;
  if (turn.norm() > 0)
    state.pose.rotation = (Quat(Eigen::AngleAxisd(turn.norm(), turn.normalized())) * state.pose.rotation).normalized();
  world.set_state(proxy, state);
}

/// Applies external forces, as the owner of a proxy does.
inline void accelerate(ContactWorld& world, const std::vector<ProxyId>& proxies, const Vec3& change) {
  for (ProxyId id : proxies)
    world.set_velocity(id, world.state(id).velocity + change, world.state(id).angular_velocity);
}

/// Finds and solves contacts, and moves the spheres.
inline void solve(ContactWorld& world, double dt) {
  world.detect();
  world.solve(dt);
  world.advance(dt);
}

inline void substep(ContactWorld& world, const std::vector<ProxyId>& proxies, double dt,
                    const Vec3& gravity = Vec3::Zero()) {
  world.detect(dt);
  accelerate(world, proxies, dt * gravity);
  world.solve(dt);
  world.advance(dt);
  for (ProxyId id : proxies) advance(world, id, dt);
}

inline const Vec3 kGravity(0, -9.81, 0);

/// The corners of a random convex chunk of about this radius.
inline ConvexPart random_chunk(std::mt19937& random, double radius) {
  std::normal_distribution<double> normal;
  ConvexPart corners;
  for (int i = 0; i < 12; ++i)
    corners.push_back(radius * Vec3(normal(random), normal(random), normal(random)).normalized());
  return corners;
}

inline RigidState at(const Vec3& position, const Vec3& velocity = Vec3::Zero()) {
  RigidState state;
  state.pose.translation = position;
  state.velocity = velocity;
  return state;
}

}  // namespace griffith::testing
