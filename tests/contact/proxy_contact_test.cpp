#include <gtest/gtest.h>

#include <cmath>

#include "tests/contact/bodies.h"

namespace griffith {
namespace {

using namespace testing;

constexpr double kHalfDt = kDt / 2;

/// Distance that a box slides in a second on a plane tilted by this angle, along a horizontal direction.
double sliding_distance(double angle, double heading, double friction) {
  const Vec3 downhill(std::cos(heading), 0, std::sin(heading));
  const Vec3 gravity = 9.81 * (std::sin(angle) * downhill - std::cos(angle) * Vec3::UnitY());
  ContactWorld world(gravity);
  world.add_ground(0, {friction, 0});
  const Vec3 size(1, 0.4, 1);
  const ProxyId box =
      world.add_proxy(box_parts(size), box_mass(size, 10), Mobility::free, at(Vec3(0, 0.2, 0)), {friction, 0});
  for (int i = 0; i < 240; ++i) substep(world, {box}, kHalfDt, gravity);
  return world.state(box).pose.translation.dot(downhill);
}

TEST(ProxyContact, ABoxSlidesWhenTheSlopeExceedsItsFriction) {
  for (double friction : {0.3, 0.7})
    for (double heading : {0.0, 0.8, 2.5}) {
      EXPECT_LT(sliding_distance(std::atan(0.98 * friction), heading, friction), 1e-4) << friction << ' ' << heading;
      const double angle = std::atan(1.02 * friction);
      const double free = 0.5 * 9.81 * (std::sin(angle) - friction * std::cos(angle));
      EXPECT_NEAR(sliding_distance(angle, heading, friction), free, 0.05 * free) << friction << ' ' << heading;
    }
}

/// Some contacts with a plane represent all of many: outer parts that hang in the air must not replace the inner one.
TEST(ProxyContact, ARoundedSideOfManyPartsRestsOnItsLowest) {
  ContactWorld world(kGravity);
  world.add_ground(0, {});
  std::vector<ConvexPart> parts;
  for (int i = -2; i <= 2; ++i) {
    parts.push_back(box_part(Vec3(0.2, 0.2, 1)));
    for (Vec3& corner : parts.back()) corner += Vec3(0.2 * i, 0.002 * i * i, 0);
  }
  const ProxyId arch = world.add_proxy(parts, box_mass(Vec3(1, 0.2, 1), 10), Mobility::free, at(Vec3(0, 0.1, 0)), {});
  double lowest = 1;
  for (int i = 0; i < 240; ++i) {
    substep(world, {arch}, kHalfDt, kGravity);
    lowest = std::min(lowest, world.state(arch).pose.translation.y());
  }
  EXPECT_GT(lowest, 0.0995);
}

TEST(ProxyContact, ABarThatTurnsIsSeenToStrikeWhereverItsCenterGoes) {
  const Vec3 size(2, 0.1, 0.1);
  for (double climb : {-0.1, 0.0, 0.1})
    for (double height : {0.3, 3.0}) {
      ContactWorld world(Vec3::Zero());
      world.add_ground(0, {});
      RigidState state = at(Vec3(0, height, 0), Vec3(0, climb, 0));
      state.angular_velocity = Vec3(0, 0, 100);  // its end comes down by 0.4 m
      world.set_impact_speed(world.add_proxy(box_parts(size), box_mass(size, 1), Mobility::free, state, {}), 1);
      world.detect();
      EXPECT_NE(world.expected_impacts(kHalfDt, 0.2, 1e-5).empty(), height < 1) << climb;
    }
}

/// A piece of a crack may overlap the others of the same crack, but nothing else.
TEST(ProxyContact, APieceThatOverlapsAnotherBodyIsPushedOut) {
  ContactWorld world(Vec3::Zero());
  const Vec3 size(1, 1, 1);
  const ProxyId other = world.add_proxy(box_parts(size), box_mass(size, 10), Mobility::free, at(Vec3::Zero()), {});
  substep(world, {other}, kHalfDt);
  const ProxyId piece = world.add_proxy(box_parts(size), box_mass(size, 10), Mobility::free, at(Vec3(0.9, 0, 0)), {});
  for (int i = 0; i < 240; ++i) substep(world, {other, piece}, kHalfDt);
  EXPECT_GT(world.state(piece).pose.translation.x() - world.state(other).pose.translation.x(), 0.998);
}

TEST(ProxyContact, AFreshCrackStaysQuiet) {
  ContactWorld world(Vec3::Zero());
  const Vec3 half(0.7, 0.3, 0.2);
  const Quat rotation(Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()));
  std::vector<ProxyId> halves;
  std::vector<Vec3> places;
  for (double side : {-1.0, 1.0}) {
    RigidState state = at(rotation * Vec3(side * half.x() / 2, 0, 0));
    state.pose.rotation = rotation;
    places.push_back(state.pose.translation);
    halves.push_back(world.add_proxy(box_parts(half), box_mass(half, 5), Mobility::free, state, {}));
  }
  for (int i = 0; i < 100; ++i) {
    substep(world, halves, kHalfDt);
    for (int k = 0; k < 2; ++k) {
      EXPECT_LT(world.state(halves[k]).velocity.norm(), 1e-13);
      EXPECT_LT(world.state(halves[k]).angular_velocity.norm(), 1e-13);
      EXPECT_LT((world.state(halves[k]).pose.translation - places[k]).norm(), 1e-13);
    }
  }
}

TEST(ProxyContact, OverlapIsAllowedWhereACrackLeftItAndNowhereElse) {
  for (bool fresh : {true, false}) {
    ContactWorld world(Vec3::Zero());
    const Vec3 size(1, 1, 1);
    std::vector<ProxyId> boxes;
    for (double x : {-0.49, fresh ? 0.49 : 3.0})
      boxes.push_back(world.add_proxy(box_parts(size), box_mass(size, 5), Mobility::free, at(Vec3(x, 0, 0)), {}));
    world.detect();
    world.set_state(boxes[1], at(Vec3(0.49, 0, 0)));
    for (int i = 0; i < 120; ++i) substep(world, boxes, kHalfDt);
    const double apart = (world.state(boxes[1]).pose.translation - world.state(boxes[0]).pose.translation).norm();
    EXPECT_NEAR(apart, fresh ? 0.98 : 1.0, 2e-3);
    EXPECT_LT(world.state(boxes[0]).velocity.norm() + world.state(boxes[1]).velocity.norm(), 1e-9);
    world.detect();
    EXPECT_LT(world.max_penetration(), 2e-3);
  }
}

TEST(ProxyContact, AnAllowanceShrinksWithTheOverlap) {
  ContactWorld world(Vec3::Zero());
  const Vec3 size(1, 1, 1);
  const ProxyId a = world.add_proxy(box_parts(size), box_mass(size, 5), Mobility::free, at(Vec3(-0.49, 0, 0)), {});
  const ProxyId b = world.add_proxy(box_parts(size), box_mass(size, 5), Mobility::free, at(Vec3(0.49, 0, 0)), {});
  for (double x : {0.49, 0.495, 0.49}) {
    world.set_state(b, at(Vec3(x, 0, 0)));
    world.set_state(a, at(Vec3(-x, 0, 0)));
    world.detect();
  }
  EXPECT_NEAR(world.max_penetration(), 0.01, 1e-4);
}

TEST(ProxyContact, AllowedOverlapsOnOppositeSidesDoNotClamp) {
  ContactWorld world(Vec3::Zero());
  constexpr double kOverlap = 1e-3;
  const Vec3 size(1, 0.1, 1);
  std::vector<ConvexPart> jaws;
  for (const double side : {-1.0, 1.0})
    for (Vec3 corner : box_part(size)) {
      if (jaws.empty() || jaws.back().size() == 8) jaws.emplace_back();
      jaws.back().push_back(corner + side * (size.y() - kOverlap) * Vec3::UnitY());
    }
  const ProxyId outer = world.add_proxy(jaws, box_mass(size, 10), Mobility::free, at(Vec3::Zero()), {0.5, 0});
  const ProxyId inner =
      world.add_proxy(box_parts(size), box_mass(size, 5), Mobility::free, at(Vec3::Zero(), Vec3(0, 0.1, 0)), {0.5, 0});
  substep(world, {outer, inner}, kDt);
  EXPECT_NEAR(world.state(inner).velocity.y(), 0.1, 1e-12);
  for (int i = 0; i < 120; ++i) substep(world, {outer, inner}, kDt);
  const Vec3 apart = world.state(inner).pose.translation - world.state(outer).pose.translation;
  EXPECT_LT(apart.y(), 3 * kOverlap) << "it stays between the jaws";
}

TEST(ProxyContact, AHeldObjectActsWithItsVelocityAndKeepsIt) {
  ContactWorld world(Vec3::Zero());
  const Vec3 size(1, 1, 1);
  const ProxyId wall =
      world.add_proxy(box_parts(size), box_mass(size, 5), Mobility::kinematic, at(Vec3::Zero(), Vec3(2, 0, 0)), {0, 1});
  const ProxyId box =
      world.add_proxy(box_parts(size), box_mass(size, 5), Mobility::free, at(Vec3(1.001, 0, 0)), {0, 1});
  substep(world, {wall, box}, kHalfDt);
  EXPECT_EQ(world.state(wall).velocity, Vec3(2, 0, 0));
  EXPECT_NEAR(world.state(box).velocity.x(), 4, 1e-5);
}

TEST(ProxyContact, HeldObjectsMeetTheGroundAndEachOtherAtFirstAndWhereTheyMove) {
  ContactWorld world(Vec3(0, -9.81, 0));
  const ProxyId ground = world.add_ground(0, {});
  const Vec3 size(1, 1, 1);
  std::vector<ProxyId> kinematic;
  for (double x : {0.0, 0.5, 3.0})
    kinematic.push_back(
        world.add_proxy(box_parts(size), box_mass(size, 5), Mobility::kinematic, at(Vec3(x, 0, 0)), {}));
  const auto meet = [&](ProxyId a, ProxyId b) {
    return std::ranges::any_of(world.contacts(), [&](const Contact& contact) {
      return (contact.a == a && contact.b == b) || (contact.a == b && contact.b == a);
    });
  };
  world.detect();
  for (const ProxyId held : kinematic) EXPECT_TRUE(meet(held, ground));
  EXPECT_TRUE(meet(kinematic[0], kinematic[1]));
  world.detect();
  EXPECT_TRUE(world.contacts().empty());
  world.solve(kHalfDt);
  world.set_state(kinematic[0], at(Vec3(0, 0.01, 0)));
  world.detect();
  EXPECT_TRUE(meet(kinematic[0], ground));
  EXPECT_TRUE(meet(kinematic[0], kinematic[1]));
  for (const Contact& contact : world.contacts())
    EXPECT_TRUE(contact.a == kinematic[0] || contact.b == kinematic[0]) << "only what has moved";
}

TEST(ProxyContact, PushingOverlapsApartLiftsNothingThatRests) {
  ContactWorld world(testing::kGravity);
  world.add_ground(0, {});
  const Vec3 size(1, 1, 1);
  const ProxyId box = world.add_proxy(box_parts(size), box_mass(size, 5), Mobility::free, at(Vec3(0, 0.45, 0)), {});
  for (int i = 0; i < 20; ++i) {
    world.detect();
    testing::accelerate(world, {box}, kHalfDt * testing::kGravity);
    world.solve(kHalfDt);
    world.advance(kHalfDt);
    testing::advance(world, box, kHalfDt);
  }
  EXPECT_LE(world.state(box).pose.translation.y(), 0.45 + 1e-6);
  EXPECT_GE(world.state(box).pose.translation.y(), 0.45 - 1e-4);
}

TEST(ProxyContact, ATiltedBodyFeelsItsFullInertia) {
  // An impulse off the center against closed form: angular velocity = I⁻¹ (arm × impulse), with a full inertia tensor.
  ContactWorld world(Vec3::Zero());
  const Vec3 size(1, 0.6, 0.3);
  const Mat3 turn = Eigen::AngleAxisd(0.6, Vec3(1, -1, 2).normalized()).toRotationMatrix();
  RigidMass mass = box_mass(size, 8);
  mass.inertia = turn * mass.inertia * turn.transpose();
  ConvexPart part = box_part(size);
  for (Vec3& corner : part) corner = turn * corner;
  const ProxyId body = world.add_proxy(std::vector<ConvexPart>{part}, mass, Mobility::free, {}, {0.5, 0.3, 0});
  const Vec3 target = turn * Vec3(0.3, 0.3, 0.1);
  world.add_sphere(0.1, 2, at(target + turn * Vec3(0, 0.1, 0), Vec3(1, -9, 2)), {0.5, 0.3, 0});
  solve(world, kHalfDt);
  ASSERT_EQ(world.contacts().size(), 1u);
  const Contact& contact = world.contacts()[0];
  const Vec3 impulse = contact.a == body ? contact.impulse : Vec3(-contact.impulse);
  const Vec3& point = contact.position;
  EXPECT_GT(impulse.norm(), 1);
  EXPECT_LT((point - target).norm(), 1e-6);
  EXPECT_LT((world.state(body).velocity - impulse / 8).norm(), 1e-9);
  EXPECT_LT((world.state(body).angular_velocity - mass.inertia.inverse() * point.cross(impulse)).norm(), 1e-6);
}

TEST(ProxyContact, AFaceThatStrikesAFaceDoesNotTurnIt) {
  const Quat turn(Eigen::AngleAxisd(1.1, Vec3(1, 3, -2).normalized()));
  ContactWorld world(Vec3::Zero());
  const Vec3 size(1, 0.4, 0.7);
  std::vector<ProxyId> boxes;
  for (double side : {-1.0, 1.0}) {
    RigidState state = at(turn * Vec3(0, side * 0.201, 0), turn * Vec3(0, -4 * side, 0));
    state.pose.rotation = turn;
    boxes.push_back(world.add_proxy(box_parts(size), box_mass(size, 5), Mobility::free, state, {0.5, 0.5}));
  }
  solve(world, kHalfDt);
  EXPECT_EQ(world.contacts().size(), 4u);
  constexpr double kTolerance = 1e-5 * 8;  // the solver's, of the speed of the impact
  for (int i = 0; i < 2; ++i) {
    EXPECT_LT((world.state(boxes[i]).velocity - turn * Vec3(0, i == 0 ? -2 : 2, 0)).norm(), kTolerance);
    EXPECT_LT(world.state(boxes[i]).angular_velocity.norm(), kTolerance);
  }
}

TEST(ProxyContact, NormalsPointFromBToAWhicheverIsMadeOfParts) {
  // A body of two parts and a box above it, in both orders.
  const Vec3 size(1, 1, 1);
  std::vector<ConvexPart> parts = {box_part(size), box_part(size)};
  for (Vec3& corner : parts[1]) corner.x() += 1.5;
  for (bool parts_first : {true, false}) {
    ContactWorld world(Vec3::Zero());
    const auto add = [&](bool of_parts) {
      return world.add_proxy(of_parts ? parts : box_parts(size), box_mass(size, 5), Mobility::free,
                             at(of_parts ? Vec3(0, 0, 0) : Vec3(0.2, 0.999, 0.1)), {0.5, 0});
    };
    const ProxyId first = add(parts_first);
    add(!parts_first);
    for (int again = 0; again < 2; ++again) {
      world.detect();
      ASSERT_EQ(world.contacts().size(), 4u);
      for (const Contact& contact : world.contacts()) {
        const double up = (contact.a == first) == parts_first ? -1 : 1;
        EXPECT_LT((contact.normal - Vec3(0, up, 0)).norm(), 1e-9) << parts_first;
        EXPECT_NEAR(contact.distance, -0.001, 1e-9);
      }
    }
  }
}

TEST(ProxyContact, ImpulsesAreTheChangesOfMomentumInAHeap) {
  const Vec3 gravity(1, -9.81, 0);
  ContactWorld world(gravity);
  world.add_ground(0, {0.8, 0.1, 0});
  std::mt19937 random(11);
  std::uniform_real_distribution<double> uniform(-1, 1);
  std::vector<ProxyId> chunks;
  const RigidMass mass = box_mass(Vec3(0.2, 0.15, 0.1), 3);
  for (int i = 0; i < 40; ++i) {
    const Vec3 place(0.4 * uniform(random), 0.6 + 0.5 * uniform(random), 0.4 * uniform(random));
    const std::vector<ConvexPart> parts = {random_chunk(random, 0.1)};
    chunks.push_back(world.add_proxy(parts, mass, Mobility::free, at(place), {0.5 + 0.4 * uniform(random), 0.3, 0}));
  }
  for (int step = 0; step < 200; ++step) {
    const double dt = step % 7 < 3 ? 1.0 / 960 : 1.0 / 120;
    std::vector<RigidState> before;
    for (ProxyId id : chunks) before.push_back(world.state(id));
    accelerate(world, chunks, dt * gravity);
    solve(world, dt);
    for (std::size_t i = 0; i < chunks.size(); ++i) {
      const RigidState after = world.state(chunks[i]);
      Vec3 impulse = Vec3::Zero(), angular_impulse = Vec3::Zero();
      for (const Contact& contact : world.contacts()) {
        if (contact.a != chunks[i] && contact.b != chunks[i]) continue;
        const Vec3 own = contact.a == chunks[i] ? contact.impulse : Vec3(-contact.impulse);
        impulse += own;
        angular_impulse += (contact.position - before[i].pose.translation).cross(own) + contact.couple;
      }
      const Mat3 rotation = before[i].pose.rotation.toRotationMatrix();
      const Mat3 inertia = rotation * mass.inertia * rotation.transpose();
      ASSERT_LT((mass.mass * (after.velocity - before[i].velocity - dt * gravity) - impulse).norm(), 1e-9);
      ASSERT_LT((inertia * (after.angular_velocity - before[i].angular_velocity) - angular_impulse).norm(), 1e-9);
    }
    for (ProxyId id : chunks) advance(world, id, dt);
  }
  EXPECT_GT(world.contacts().size(), 60u);
}

TEST(ProxyContact, ATowerStands) {
  ContactWorld world(Vec3(0, -9.81, 0));
  world.add_ground(0, {});
  const Vec3 size(0.4, 0.2, 0.3);
  std::vector<ProxyId> boxes;
  for (int i = 0; i < 8; ++i)
    boxes.push_back(
        world.add_proxy(box_parts(size), box_mass(size, 5), Mobility::free, at(Vec3(0, 0.1 + 0.2 * i, 0)), {}));
  for (int i = 0; i < 480; ++i) substep(world, boxes, kHalfDt, kGravity);
  for (int i = 0; i < 8; ++i) {
    EXPECT_LT((world.state(boxes[i]).pose.translation - Vec3(0, 0.1 + 0.2 * i, 0)).norm(), 5e-3) << i;
    EXPECT_LT(world.state(boxes[i]).velocity.norm(), 1e-2) << i;
  }
}

TEST(ProxyContact, RemovedAndReshapedObjectsLeaveNoContactBehind) {
  ContactWorld world(Vec3(0, -9.81, 0));
  world.add_ground(0, {});
  const Vec3 size(1, 1, 1), smaller(1, 0.5, 1);
  const ProxyId lower = world.add_proxy(box_parts(size), box_mass(size, 5), Mobility::free, at(Vec3(0, 0.5, 0)), {});
  const ProxyId upper = world.add_proxy(box_parts(size), box_mass(size, 5), Mobility::free, at(Vec3(0, 1.5, 0)), {});
  substep(world, {lower, upper}, kHalfDt, kGravity);
  EXPECT_FALSE(world.contacts().empty());
  world.reshape(lower, box_parts(smaller), box_mass(smaller, 2.5), Mobility::free, at(Vec3(0, 0.25, 0)));
  world.detect();
  for (const Contact& contact : world.contacts()) EXPECT_TRUE(contact.a != upper && contact.b != upper);
  world.remove(lower);
  EXPECT_TRUE(world.contacts().empty());
  for (int i = 0; i < 480; ++i) substep(world, {upper}, kHalfDt, kGravity);
  EXPECT_NEAR(world.state(upper).pose.translation.y(), 0.5, 1e-3);
}

TEST(ProxyContact, PiecesOfACrackMayOverlapButNotADeformedBodyAndAnother) {
  const Vec3 size(1, 1, 1), taller(1, 1.1, 1);
  for (const bool is_crack : {true, false}) {
    ContactWorld world(Vec3(0, -9.81, 0));
    const ProxyId lower = world.add_proxy(box_parts(size), box_mass(size, 5), Mobility::free, at(Vec3(0, 0.5, 0)), {});
    const ProxyId upper = world.add_proxy(box_parts(size), box_mass(size, 5), Mobility::free, at(Vec3(0, 1.5, 0)), {});
    substep(world, {lower, upper}, kHalfDt, kGravity);
    const RigidState stretched = at(Vec3(0, 0.55, 0));
    if (is_crack) {
      world.reshape(lower, box_parts(taller), box_mass(taller, 5), Mobility::free, stretched);
      world.reshape(upper, box_parts(size), box_mass(size, 5), Mobility::free, world.state(upper));
    } else {
      world.deform(lower, box_parts(taller), box_mass(taller, 5), stretched);
    }
    world.detect();
    EXPECT_FALSE(world.contacts().empty());
    EXPECT_NEAR(world.allowed_overlap(lower, upper), is_crack ? 0.1 : 0, 0.01) << is_crack;
  }
}

}  // namespace
}  // namespace griffith
