#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/solver/rigid_contacts.h"

namespace griffith {
namespace {

using testing::axes_of;
using testing::expect_no_energy_of_few_rounds;
using testing::kExact;
using testing::on_floor;
using testing::random_problem;
using testing::RandomValues;
using testing::velocity_after;
using testing::work_of;

TEST(ContactRebound, ABlockThatLandsFlatPartsAtItsSpeedOfRebound) {
  const std::vector<RigidInertia> block = {{2, 0.3 * Mat3::Identity()}};
  std::vector<FrictionContact> contacts;
  for (const double x : {-0.5, 0.5})
    for (const double z : {-0.5, 0.5}) {
      contacts.push_back(on_floor(0, Vec3(x, -0.5, z), 0.4, Vec3(0, -3, 0)));
      contacts.back().rebound = 1.2;
    }
  std::vector<NodeVectors> changes;
  EXPECT_EQ(solve_contact_problem({}, block, contacts, kExact, changes).unconverged, 0);
  for (const FrictionContact& contact : contacts)
    EXPECT_NEAR((velocity_after(block, contacts, contact) - Vec3(1.2, 0, 0)).norm(), 0, 1e-6);
}

/// Contacts of a ball in a slot that fits it, as it hits one wall.
std::vector<FrictionContact> in_a_slot() {
  std::vector<FrictionContact> contacts(2);
  for (const double side : {-1, 1}) {
    FrictionContact& contact = contacts[side < 0 ? 0 : 1];
    contact.a = {.body = 0, .arm = Vec3(0, side, 0)};
    contact.axes = axes_of(-side * Vec3::UnitY());
    contact.free_velocity = contact.axes.transpose() * Vec3(0, -3, 0);
  }
  contacts[0].rebound = 1.5;
  return contacts;
}

TEST(ContactRebound, WhatIsHeldFromBehindDoesNotRebound) {
  const std::vector<RigidInertia> ball = {{1, 0.4 * Mat3::Identity()}};
  std::vector<FrictionContact> contacts = in_a_slot();
  std::vector<NodeVectors> changes;
  EXPECT_EQ(solve_contact_problem({}, ball, contacts, kExact, changes).unconverged, 0);
  for (const FrictionContact& contact : contacts) EXPECT_NEAR(velocity_after(ball, contacts, contact)[0], 0, 1e-6);
  EXPECT_NEAR(contacts[0].impulse[0], 3 * (1 + 0.5), 1e-5);
  EXPECT_NEAR(contacts[1].impulse[0], 3 * 0.5, 1e-5);
}

// What pushes against each other moves nothing: taken as a guess of compression it would grow from solve to solve.
TEST(ContactRebound, ImpulsesOfAnImpactThatIsSolvedAgainStay) {
  const std::vector<RigidInertia> ball = {{1, 0.4 * Mat3::Identity()}};
  std::vector<FrictionContact> contacts = in_a_slot();
  std::vector<NodeVectors> changes;
  for (int solve = 0; solve < 5; ++solve) {
    EXPECT_EQ(solve_contact_problem({}, ball, contacts, kExact, changes).unconverged, 0);
    EXPECT_NEAR(contacts[0].impulse[0], 3 * (1 + 0.5), 1e-5) << "solve " << solve;
  }
}

TEST(ContactRebound, RandomImpactsConvergeAndAddNoEnergy) {
  RandomValues random(5);
  int solved = 0, rebounding = 0;
  for (int trial = 0; trial < 100; ++trial) {
    auto [bodies, contacts] = random_problem(random);
    const double share = random.uniform(0, 1);
    for (FrictionContact& contact : contacts) {
      contact.target_velocity = 0;
      contact.rebound = share * std::max(0.0, -contact.free_velocity[0]);
    }
    std::vector<NodeVectors> changes;
    std::vector<FrictionContact> without = contacts;
    for (FrictionContact& contact : without) contact.rebound = 0;
    const bool is_hard = solve_contact_problem({}, bodies, without, kExact, changes).unconverged > 0;
    const bool converged = solve_contact_problem({}, bodies, contacts, kExact, changes).unconverged == 0;
    EXPECT_LE(work_of(bodies, contacts), 1e-9) << "trial " << trial;
    if (is_hard) continue;  // with random normals friction may jam
    ++solved;
    EXPECT_TRUE(converged) << "trial " << trial;
    if (!converged) continue;
    for (const FrictionContact& contact : contacts) {
      EXPECT_GE(velocity_after(bodies, contacts, contact)[0], -1e-5);
      EXPECT_LE(contact.impulse.tail<2>().norm(), contact.friction * contact.impulse[0] + 1e-4);
      rebounding += contact.given_back[0] > 0;
    }
  }
  EXPECT_GT(solved, 60);
  EXPECT_GT(rebounding, 100);
}

constexpr double kSlack = 0.2;  // [m/s]

/// A ball that hits the floor, bonded to it by a bond that bears `strength` [N·s].
std::vector<FrictionContact> bonded_to_the_floor(double strength) {
  std::vector<FrictionContact> contacts(2, on_floor(0, Vec3::Zero(), 0, Vec3(0, -3, 0)));
  contacts[0].rebound = 1.5;
  contacts[1].hold = Hold{Vec3::Zero(), kSlack, strength};
  return contacts;
}

TEST(ContactRebound, ABondHoldsWhatReboundsAsFarAsItsStrengthReaches) {
  const std::vector<RigidInertia> ball = {{2, Mat3::Identity()}};
  for (const double strength : {0.5, 2.5, 2.7, 100.0}) {
    std::vector<FrictionContact> contacts = bonded_to_the_floor(strength);
    std::vector<NodeVectors> changes;
    EXPECT_EQ(solve_contact_problem({}, ball, contacts, kExact, changes).unconverged, 0);
    const double held = std::min(strength, 2 * (1.5 - kSlack));
    EXPECT_NEAR((contacts[1].impulse - Vec3(-held, 0, 0)).norm(), 0, 1e-5);
    EXPECT_NEAR(velocity_after(ball, contacts, contacts[0])[0], 1.5 - held / 2, 1e-5);
  }
}

// Two balls that fly apart, one of them into the floor: as that rebounds, the bond has less to hold.
TEST(ContactRebound, ABondLetsGoWhatAReboundBringsTogether) {
  const std::vector<RigidInertia> balls(2, {1, Mat3::Identity()});
  std::vector<FrictionContact> contacts(2, on_floor(0, Vec3::Zero(), 0, Vec3(0, -3, 0)));
  contacts[0].rebound = 1.5;
  contacts[1] = on_floor(1, Vec3::Zero(), 0, Vec3(0, 4, 0));
  contacts[1].b.body = 0;
  contacts[1].hold = Hold{Vec3(5, 0, 0), 5, 100};
  std::vector<NodeVectors> changes;
  EXPECT_EQ(solve_contact_problem({}, balls, contacts, kExact, changes).unconverged, 0);
  EXPECT_NEAR(contacts[0].impulse[0], 3, 1e-5) << "2 in compression, a half of that in restitution";
  EXPECT_NEAR((contacts[1].impulse - Vec3(-0.5, 0, 0)).norm(), 0, 1e-5) << "1 in compression";
}

TEST(ContactRebound, RandomBondsKeepTheirLaw) {
  RandomValues random(7);
  int given = 0, holding = 0, opening = 0, free = 0;
  for (int trial = 0; trial < 60; ++trial) {
    auto [bodies, contacts] = random_problem(random);
    for (FrictionContact& contact : contacts) {
      contact.target_velocity = contact.friction = 0;
      if (random.index(2) == 0)
        contact.hold = Hold{random.vector(), random.uniform(0.5, 2), std::pow(10, random.uniform(-2, 1))};
      else
        contact.rebound = std::max(0.0, -0.5 * contact.free_velocity[0]);
    }
    std::vector<NodeVectors> changes;
    if (solve_contact_problem({}, bodies, contacts, kExact, changes).unconverged > 0) continue;
    for (const FrictionContact& contact : contacts) {
      if (!contact.hold) continue;
      const Vec3 apart = contact.hold->apart + velocity_after(bodies, contacts, contact);
      const double beyond = apart.norm() - contact.hold->slack, impulse = contact.impulse.norm();
      EXPECT_LE(impulse, contact.hold->strength + 1e-4);
      EXPECT_LE(std::min(contact.hold->strength - impulse, beyond), 1e-4) << "it opens at its strength alone";
      EXPECT_LE(std::min(impulse, -beyond), 1e-4) << "what is closer moves freely";
      EXPECT_NEAR(contact.impulse.dot(apart), -impulse * apart.norm(), 1e-3 * (1 + impulse));
      given += !contact.given_back.isZero(1e-4);
      free += beyond < -1e-4;
      opening += beyond > 1e-4;
      holding += std::abs(beyond) <= 1e-4;
    }
  }
  EXPECT_GT(std::min({given, holding, opening, free}), 20);
}

TEST(ContactRebound, WhatDoesNotConvergeAddsNoEnergy) {
  expect_no_energy_of_few_rounds(6, [](RandomValues& random, std::vector<FrictionContact>& contacts) {
    for (FrictionContact& contact : contacts) {
      contact.target_velocity = 0;
      contact.rebound = random.uniform(0, 1) * std::max(0.0, -contact.free_velocity[0]);
    }
  });
}

}  // namespace
}  // namespace griffith
