#pragma once

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

#include "sim/solver/contact_problem.h"
#include "tests/random_values.h"

namespace griffith::testing {

constexpr ContactTolerance kExact{.relative = 1e-7, .negligible_speed = 1e-12, .max_rounds = 60};

inline Mat3 axes_of(const Vec3& normal) {
  Mat3 axes;
  axes << normal, normal.unitOrthogonal(), normal.cross(normal.unitOrthogonal());
  return axes;
}

/// Contact of a rigid body at an arm with what does not move, below it.
inline FrictionContact on_floor(int body, const Vec3& arm, double friction, const Vec3& velocity) {
  FrictionContact contact;
  contact.a = {.body = body, .arm = arm};
  contact.axes = axes_of(Vec3::UnitY());
  contact.friction = friction;
  contact.free_velocity = contact.axes.transpose() * velocity;
  return contact;
}

/// Velocity of a rigid body's point by the impulses of the contacts that name it.
inline Vec3 change_at(std::span<const RigidInertia> bodies, std::span<const FrictionContact> contacts,
                      const ContactSide& side) {
  if (side.body < 0) return Vec3::Zero();
  Vec3 force = Vec3::Zero(), torque = Vec3::Zero();
  for (const FrictionContact& contact : contacts)
    for (const auto& [of, sign] : {std::pair(&contact.a, 1.0), std::pair(&contact.b, -1.0)}) {
      if (of->body != side.body) continue;
      const Vec3 impulse = sign * (contact.axes * contact.impulse);
      force += impulse;
      torque += of->arm.cross(impulse);
    }
  const RigidInertia& body = bodies[side.body];
  return force / body.mass + (body.inertia.inverse() * torque).cross(side.arm);
}

/// Velocity of a contact after all impulses, along its axes [m/s].
inline Vec3 velocity_after(std::span<const RigidInertia> bodies, std::span<const FrictionContact> contacts,
                           const FrictionContact& contact) {
  return contact.free_velocity +
         contact.axes.transpose() * (change_at(bodies, contacts, contact.a) - change_at(bodies, contacts, contact.b));
}

/// Work of the impulses: what the bodies gained [J].
inline double work_of(std::span<const RigidInertia> bodies, std::span<const FrictionContact> contacts) {
  double work = 0;
  for (const FrictionContact& contact : contacts)
    work += contact.impulse.dot(contact.free_velocity + velocity_after(bodies, contacts, contact)) / 2;
  return work;
}

struct RigidProblem {
  std::vector<RigidInertia> bodies;
  std::vector<FrictionContact> contacts;
};

inline RigidProblem random_problem(RandomValues& random) {
  RigidProblem problem;
  problem.bodies.resize(2 + random.index(4));
  for (RigidInertia& body : problem.bodies) {
    body.mass = std::pow(10, random.uniform(-2, 2));
    const Mat3 turn = random.rotation();
    body.inertia = body.mass * turn * Vec3(0.1, 0.2, 0.25).asDiagonal() * turn.transpose();
  }
  const auto random_body = [&] { return random.index(static_cast<int>(problem.bodies.size())); };
  problem.contacts.resize(3 + random.index(10));
  for (FrictionContact& contact : problem.contacts) {
    contact.a = {.body = random_body(), .arm = random.vector()};
    if (random.index(3) > 0) contact.b = {.body = random_body(), .arm = random.vector()};
    if (contact.b.body == contact.a.body) contact.b.body = -1;
    contact.axes = axes_of(random.direction());
    contact.friction = random.uniform(0, 0.6);
    contact.free_velocity = random.vector(2);
    contact.target_velocity = random.index(2) == 0 ? 0 : -random.uniform(0, 1);
  }
  return problem;
}

/// Expects that few rounds and Newton steps, which leave random problems unsolved, add no energy. `complete` is called
/// with the random values and the contacts of each problem.
template <class Complete>
void expect_no_energy_of_few_rounds(int seed, const Complete& complete) {
  RandomValues random(seed);
  int unconverged = 0;
  for (int trial = 0; trial < 200; ++trial) {
    auto [bodies, contacts] = random_problem(random);
    complete(random, contacts);
    ContactTolerance few = kExact;
    few.max_rounds = 1 + trial % 12;
    few.max_newton_steps = 1 + trial % 5;
    std::vector<NodeVectors> changes;
    if (solve_contact_problem({}, bodies, contacts, few, changes).unconverged == 0) continue;
    ++unconverged;
    EXPECT_LE(work_of(bodies, contacts), 1e-9) << "trial " << trial;
  }
  EXPECT_GT(unconverged, 50);
}

}  // namespace griffith::testing
