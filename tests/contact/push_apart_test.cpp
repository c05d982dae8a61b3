// Overlaps of rigid bodies go by displacements.

#include <gtest/gtest.h>

#include <vector>

#include "sim/contact/rigid_overlaps.h"

namespace griffith::contact {
namespace {

constexpr double kResting = 1e-4;  // [m]

/// Balls in a row along x, of these masses; what has none does not move.
std::vector<RigidBody> row_of(const std::vector<double>& masses) {
  std::vector<RigidBody> bodies(masses.size());
  for (std::size_t i = 0; i < masses.size(); ++i) {
    bodies[i].moves = masses[i] > 0;
    if (!bodies[i].moves) continue;
    bodies[i].inverse_mass = 1 / masses[i];
    bodies[i].inverse_inertia = 1 / (0.4 * masses[i]) * Mat3::Identity();
  }
  return bodies;
}

/// Contacts of neighbors at these distances, each acting beside the line of the centers.
std::vector<RigidContact> contacts_at(const std::vector<double>& distances) {
  std::vector<RigidContact> contacts(distances.size());
  for (std::size_t i = 0; i < distances.size(); ++i) {
    contacts[i].a = static_cast<int>(i) + 1;
    contacts[i].b = static_cast<int>(i);
    contacts[i].normal = Vec3::UnitX();
    contacts[i].arm_a = Vec3(-1, 0.2, 0.1);
    contacts[i].arm_b = Vec3(1, 0.2, 0.1);
    contacts[i].distance = distances[i];
    contacts[i].resting = kResting;
  }
  return contacts;
}

RigidGroup all_of(const std::vector<RigidBody>& bodies, const std::vector<RigidContact>& contacts) {
  RigidGroup group;
  for (std::size_t i = 0; i < bodies.size(); ++i)
    if (bodies[i].moves) group.bodies.push_back(static_cast<int>(i));
  for (std::size_t i = 0; i < contacts.size(); ++i) group.contacts.push_back(static_cast<int>(i));
  return group;
}

double opening(const std::vector<RigidBody>& bodies, const RigidContact& contact) {
  const RigidBody &a = bodies[contact.a], &b = bodies[contact.b];
  return contact.normal.dot(a.push + a.push_rotation.cross(contact.arm_a) - b.push -
                            b.push_rotation.cross(contact.arm_b));
}

TEST(PushApart, AFifthOfADeepOverlapGoesAndMomentaBalance) {
  std::vector<RigidBody> bodies = row_of({2, 5});
  std::vector<RigidContact> contacts = contacts_at({-0.01});
  const RigidGroup group = all_of(bodies, contacts);
  push_apart(bodies, contacts, {{group}}, 0.2);
  EXPECT_NEAR(opening(bodies, contacts[0]), 0.2 * (0.01 - kResting), 1e-9);
  EXPECT_LT((2 * bodies[0].push + 5 * bodies[1].push).norm(), 1e-15);
}

TEST(PushApart, NothingElseIsMadeToOverlapAndWhatIsHeldStays) {
  std::vector<RigidBody> bodies = row_of({0, 1, 3, 1});
  std::vector<RigidContact> contacts = contacts_at({-kResting, -0.01, 1e-5});
  const RigidGroup group = all_of(bodies, contacts);
  push_apart(bodies, contacts, {{group}}, 0.2);
  EXPECT_TRUE(bodies[0].push.isZero(0)) << "held";
  const double pushed = opening(bodies, contacts[1]), left = 0.2 * pushed;  // by ten sweeps
  EXPECT_GT(pushed, 0.15 * 0.01);
  EXPECT_GT(opening(bodies, contacts[0]), -left) << "against what is held";
  EXPECT_GT(contacts[2].distance + opening(bodies, contacts[2]), -kResting - left) << "across a gap";
}

TEST(PushApart, WhatMayOverlapStays) {
  std::vector<RigidBody> bodies = row_of({1, 1});
  std::vector<RigidContact> contacts = contacts_at({-0.9 * kResting});
  const RigidGroup group = all_of(bodies, contacts);
  push_apart(bodies, contacts, {{group}}, 0.2);
  EXPECT_TRUE(bodies[0].push.isZero(0) && bodies[1].push_rotation.isZero(0));
}

}  // namespace
}  // namespace griffith::contact
