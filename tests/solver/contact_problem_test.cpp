#include "sim/solver/contact_problem.h"

#include <gtest/gtest.h>

#include "sim/core/parallel.h"
#include "tests/random_values.h"
#include "tests/solver/elastic_box.h"
#include "tests/solver/rigid_contacts.h"

namespace griffith {
namespace {

using testing::axes_of;
using testing::ElasticBox;
using testing::expect_no_energy_of_few_rounds;
using testing::kExact;
using testing::on_floor;
using testing::random_problem;
using testing::RandomValues;
using testing::velocity_after;

constexpr double kStepTime = 1.0 / 120, kFall = 9.81;
/// Expects Signorini's and Coulomb's laws of a contact with this relative velocity along its axes.
void expect_laws(const FrictionContact& contact, const Vec3& velocity, double speed, double impulse) {
  const double parting = velocity[0] - contact.target_velocity, limit = contact.friction * contact.impulse[0];
  EXPECT_GE(contact.impulse[0], 0);
  EXPECT_GE(parting, -speed);
  EXPECT_LE(contact.impulse.tail<2>().norm(), limit + impulse);
  if (contact.impulse[0] > impulse) {
    EXPECT_LE(parting, speed);
  }
  const double sliding = velocity.tail<2>().norm();
  if (contact.impulse.tail<2>().norm() < limit - impulse) {
    EXPECT_LE(sliding, speed) << "sticks";
  } else if (sliding > speed && limit > impulse) {
    EXPECT_LT(contact.impulse.tail<2>().dot(velocity.tail<2>()), -0.999 * limit * sliding + impulse * speed);
  }
}

// Two free masses that fly apart: held at the slack by what it takes, or slowed by the strength where that is less.
TEST(Bond, StopsWhatComesApartOrGivesItsStrength) {
  const std::vector<RigidInertia> bodies = {{1.0, Mat3::Identity()}, {3.0, Mat3::Identity()}};
  const Vec3 before(0.1, 0, 0), velocity(0.3, 0.4, 0);
  for (const double slack : {0.2, 0.5}) {
    const Vec3 free = before + velocity;
    const double needed = 0.75 * (free.norm() - slack);  // of the reduced mass
    for (const double strength : {0.3 * needed, 0.99 * needed, 1.5 * needed, 100 * needed}) {
      std::vector<FrictionContact> bonds(1);
      bonds[0].a.body = 0, bonds[0].b.body = 1;
      bonds[0].free_velocity = velocity;
      bonds[0].hold = Hold{before, slack, strength};
      std::vector<NodeVectors> changes;
      EXPECT_EQ(solve_contact_problem({}, bodies, bonds, kExact, changes).unconverged, 0);
      EXPECT_NEAR(bonds[0].impulse.norm(), std::min(strength, needed), 1e-6);
      EXPECT_LT(bonds[0].impulse.normalized().dot(free.normalized()), -1 + 1e-9);
    }
  }
}

TEST(Bond, LetsWhatIsCloserMoveFreely) {
  const std::vector<RigidInertia> bodies = {{1.0, Mat3::Identity()}};
  std::vector<FrictionContact> bonds(1);
  bonds[0].a.body = 0;
  bonds[0].free_velocity = Vec3(-0.3, 0.1, 0);
  bonds[0].hold = Hold{Vec3(0.2, 0, 0), 0.2, 1};
  std::vector<NodeVectors> changes;
  EXPECT_EQ(solve_contact_problem({}, bodies, bonds, kExact, changes).unconverged, 0);
  EXPECT_TRUE(bonds[0].impulse.isZero(0));
}

// Painlevé (1895): above µ = 4/3, a rod that leans by tan θ = 2 and is pulled along the floor can leave it or jam. Both
// meet all laws; what stuck before sticks.
TEST(ContactProblem, OfTwoSolutionsAContactKeepsTheOneThatItHad) {
  const double cosine = std::sqrt(0.2), sine = std::sqrt(0.8);
  const std::vector<RigidInertia> bodies = {{1.0, Mat3::Identity() / 3}};
  FrictionContact contact = on_floor(0, -Vec3(cosine, sine, 0), 2, Vec3(-0.1, 0.001, 0));
  std::vector<NodeVectors> changes;
  for (const bool stuck : {true, false}) {
    contact.impulse = stuck ? Vec3(contact.axes.transpose() * Vec3(0.03, 0.03, 0)) : Vec3::Zero();
    std::vector<FrictionContact> contacts = {contact};
    EXPECT_EQ(solve_contact_problem({}, bodies, contacts, kExact, changes).unconverged, 0);
    const Vec3 velocity = velocity_after(bodies, contacts, contacts[0]);
    expect_laws(contacts[0], velocity, 1e-7, 1e-7);
    EXPECT_EQ(contacts[0].impulse[0] > 0, stuck);
    EXPECT_NEAR(velocity.norm(), stuck ? 0 : contacts[0].free_velocity.norm(), 1e-7);
  }
}

TEST(ContactProblem, RandomRigidBodiesKeepTheLaws) {
  RandomValues random(3);
  for (int trial = 0; trial < 40; ++trial) {
    auto [bodies, contacts] = random_problem(random);
    std::vector<NodeVectors> changes;
    const ContactSolveReport report = solve_contact_problem({}, bodies, contacts, kExact, changes);
    if (report.unconverged > 0) continue;  // with random normals there may be no solution
    for (const FrictionContact& contact : contacts)
      expect_laws(contact, velocity_after(bodies, contacts, contact), 1e-5, 1e-4);
  }
}

TEST(ContactProblem, WhatDoesNotConvergeAddsNoEnergy) {
  expect_no_energy_of_few_rounds(4, [](RandomValues& random, std::vector<FrictionContact>& contacts) {
    for (FrictionContact& contact : contacts) contact.impulse = random.direction() * 10;  // of an earlier step
  });
}

TEST(ContactProblem, ASlidingBlockIsSlowedByFrictionAlone) {
  const std::vector<RigidInertia> block = {{2, Mat3::Identity()}};
  for (double speed : {0.01, 1.0, 30.0}) {
    std::vector<FrictionContact> contacts;
    for (double x : {-0.5, 0.5})
      for (double z : {-0.5, 0.5})
        contacts.push_back(
            on_floor(0, Vec3(x, 0, z), 0.3, Vec3(speed, -kFall * kStepTime, 0)));  // at its center's height
    std::vector<NodeVectors> changes;
    EXPECT_EQ(solve_contact_problem({}, block, contacts, kExact, changes).unconverged, 0);
    Vec3 impulse = Vec3::Zero();
    for (const FrictionContact& contact : contacts) impulse += contact.axes * contact.impulse;
    EXPECT_NEAR(impulse.y(), 2 * kFall * kStepTime, 1e-6) << "it neither sinks nor lifts off";
    EXPECT_NEAR(-impulse.x(), std::min(0.3 * impulse.y(), 2 * speed), 1e-6);
  }
}

TEST(ContactProblem, TheHeavyRestsOnTheLight) {
  for (double ratio : {1e2, 1e3, 1e4}) {
    std::vector<RigidInertia> bodies = {{1, Mat3::Identity()}, {ratio, ratio * Mat3::Identity()}};
    std::vector<FrictionContact> contacts = {on_floor(0, Vec3::Zero(), 0.5, Vec3(0, -kFall * kStepTime, 0)),
                                             on_floor(1, Vec3::Zero(), 0.5, Vec3::Zero())};
    contacts[1].b = {.body = 0, .arm = Vec3::Zero()};
    std::vector<NodeVectors> changes;
    EXPECT_EQ(solve_contact_problem({}, bodies, contacts, {}, changes).unconverged, 0) << ratio;
    EXPECT_NEAR(contacts[0].impulse[0], (1 + ratio) * kFall * kStepTime, 1e-3 * ratio * kFall * kStepTime);
  }
}

/// The end of a rod that slides changes its speed with the impulse that carries it: more than that changes with what
/// the sliding lifts, so that neither can be found after the other.
TEST(ContactProblem, ASteepRodSlidesOnItsEnd) {
  for (const double degrees : {20.0, 40.0, 60.0, 75.0})
    for (const double speed : {-2.0, 2.0}) {
      const double angle = degrees * M_PI / 180, half = 0.5;
      const std::vector<RigidInertia> rod = {{1, half * half / 3 * Mat3::Identity()}};
      std::vector<FrictionContact> contacts = {
          on_floor(0, -half * Vec3(std::cos(angle), std::sin(angle), 0), 0.7, Vec3(speed, -1, 0))};
      std::vector<NodeVectors> changes;
      const ContactSolveReport report = solve_contact_problem({}, rod, contacts, {}, changes);
      EXPECT_EQ(report.unconverged, 0) << degrees << "° " << speed;
      EXPECT_LE(report.newton_steps, 30) << degrees << "° " << speed;
      expect_laws(contacts[0], velocity_after(rod, contacts, contacts[0]), 1e-3, 1e-3);
    }
}

/// A box of elastic elements above a floor, about to fall for a step.
struct FallingBox {
  ElasticBox body;
  ElasticSystem system = body.system();
  WholeMotion whole;
  std::vector<FrictionContact> contacts;

  explicit FallingBox(double friction, const Vec3& velocity = Vec3::Zero())
      : FallingBox({Vec3(0.4, 0.2, 0.4), 0.1, 6e10}, friction, velocity) {}
  FallingBox(ElasticBox box, double friction, const Vec3& velocity, double dt = kStepTime) : body(std::move(box)) {
    body.assemble(system, {.dt = dt});
    whole = free_motion(system.gather(body.positions),
                        Eigen::Map<const Eigen::VectorXd>(body.masses.data(), body.masses.size()));
    double lowest = 0;
    for (const Vec3& position : body.positions) lowest = std::min(lowest, position.y());
    for (int row = 0; row < system.rows(); ++row) {
      if (body.positions[system.nodes()[row]].y() > lowest + 1e-9) continue;
      FrictionContact& contact = contacts.emplace_back();
      contact.a = {
          .body = 0, .deformable = true, .point = {{row, -1, -1}, {Mat3::Identity(), Mat3::Zero(), Mat3::Zero()}}};
      contact.axes = axes_of(Vec3::UnitY());
      contact.friction = friction;
      contact.free_velocity = contact.axes.transpose() * (velocity - kFall * kStepTime * Vec3::UnitY());
    }
  }
  double mass() const { return whole.masses.sum(); }
  NodeVectors solve(const ContactTolerance& tolerance, ContactSolveReport* report = nullptr) {
    const std::vector<DeformableInertia> bodies = {{&system.matrix(), &system.preconditioner(), {}, whole}};
    std::vector<NodeVectors> changes;
    const ContactSolveReport found = solve_contact_problem(bodies, {}, contacts, tolerance, changes);
    if (report) *report = found;
    return changes[0];
  }
};

TEST(ContactProblem, AnElasticBoxIsCarriedByItsFace) {
  FallingBox box(0.6);
  ContactSolveReport report;
  const NodeVectors change = box.solve({.negligible_speed = 1e-9}, &report);
  EXPECT_EQ(report.unconverged, 0);
  double carried = 0;
  for (const FrictionContact& contact : box.contacts) carried += contact.impulse[0];
  EXPECT_NEAR(carried, box.mass() * kFall * kStepTime, 1e-3 * carried);
  const Vec3 gained = change * box.whole.masses;
  EXPECT_NEAR(gained.y(), carried, 1e-12 * carried) << "momentum is exact, whatever residual is left";
  for (const FrictionContact& contact : box.contacts)
    EXPECT_NEAR(change(1, contact.a.point.rows[0]), kFall * kStepTime, 1e-3 * kFall * kStepTime);
}

TEST(ContactProblem, AnElasticBoxSlidesAsARigidOneDoes) {
  FallingBox box(0.2, Vec3(0.5, 0, 0));
  const NodeVectors change = box.solve({.negligible_speed = 1e-9});
  const Vec3 gained = change * box.whole.masses;
  EXPECT_NEAR(-gained.x(), 0.2 * box.mass() * kFall * kStepTime, 2e-3 * box.mass() * kFall * kStepTime);
  EXPECT_NEAR(gained.y(), box.mass() * kFall * kStepTime, 1e-3 * box.mass() * kFall * kStepTime);
}

TEST(ContactProblem, AStiffChipIsCaughtInALongStep) {
  constexpr double kLongStep = 1.0 / 30;
  for (const Vec3& spin : {Vec3(0, 0, 0), Vec3(3, 20, 7), Vec3(-40, 5, 11)}) {
    FallingBox chip({Vec3(5e-3, 1e-3, 5e-3), 1.65e-3, 6e10}, 0.5, Vec3(0.3, -0.2, 0.1), kLongStep);
    for (FrictionContact& contact : chip.contacts)
      contact.free_velocity +=
          contact.axes.transpose() * spin.cross(Vec3(chip.whole.arms.col(contact.a.point.rows[0])));
    ContactSolveReport report;
    const NodeVectors change = chip.solve({}, &report);
    EXPECT_EQ(report.unconverged, 0) << spin.transpose();
    EXPECT_LT(report.newton_steps, 60) << "up to 529 where contacts begin as stiff as the elements";
    EXPECT_LT(change.colwise().norm().maxCoeff(), 1) << "no faster than it came";
  }
}

TEST(ContactProblem, TheWholeOfABodyTakesPartOnce) {
  const FallingBox box(0.5);
  RandomValues random(5);
  NodeVectors v(3, box.whole.arms.cols());
  for (Eigen::Index i = 0; i < v.cols(); ++i) v.col(i) = random.vector();
  const NodeVectors part = box.whole.part_of(v);
  EXPECT_TRUE(box.whole.part_of(part).isApprox(part));
  const NodeVectors momentum = box.whole.momentum_of(v);
  EXPECT_TRUE(box.whole.momentum_of(momentum).isApprox(momentum));
  NodeVectors w(3, v.cols());
  for (Eigen::Index i = 0; i < w.cols(); ++i) w.col(i) = random.vector();
  EXPECT_NEAR(dot(w, box.whole.momentum_of(v)), dot(box.whole.part_of(w), v), 1e-9) << "Q and its transpose";
}

TEST(ContactProblem, GivesTheSameBitsOnAnyNumberOfThreads) {
  std::vector<NodeVectors> found;
  for (int threads : {1, 2, 4}) {
    const ThreadLimit limit(threads);
    FallingBox box(0.4, Vec3(0.3, 0, 0.1));
    found.push_back(box.solve({}));
  }
  EXPECT_EQ(found[0], found[1]);
  EXPECT_EQ(found[0], found[2]);
}

}  // namespace
}  // namespace griffith
