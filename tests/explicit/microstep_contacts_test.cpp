#include "sim/explicit/microstep_contacts.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "sim/elasticity/material.h"

namespace griffith::explicit_dynamics {
namespace {

using Corners4 = std::array<Vec3, 4>;

/// Face 3 of the first lies on face 3 of the second: corners 0, 1, 2 of one are 0, 2, 1 of the other.
const Corners4 kLower = {Vec3(0, 0, 0), Vec3(0, 1, 0), Vec3(1, 0, 0), Vec3(0.2, 0.3, -1)};
const Corners4 kUpper = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0.2, 0.3, 1)};

/// Single tets, each a body of its own family, in one solid.
struct Tets {
  ExplicitBodies bodies;
  std::vector<SurfaceSide> surface;
  std::vector<SurfaceLaw> laws;
  bool is_finished = false;

  int add(const Corners4& places, const Vec3& velocity, const Vec3& acceleration = Vec3::Zero()) {
    const Material material;
    Corners corners;
    for (int i = 0; i < 4; ++i) corners.col(i) = places[i];
    const RestElement rest = rest_element(corners);
    std::array<int, 4> nodes{};
    for (int i = 0; i < 4; ++i)
      nodes[i] = bodies.add_node({places[i], Vec3::Zero(), velocity, acceleration, material.density * rest.volume / 4});
    const std::vector<std::array<int, 4>> tets = {nodes};
    const std::vector<RestElement> rest_elements = {rest};
    const std::vector<Mat3> offsets = {Mat3::Zero()};
    bodies.add_body(elastic_law(material), material.density, tets, rest_elements, offsets);
    const int slot = bodies.slot(bodies.body_count() - 1, 0);
    for (int face = 0; face < 4; ++face) surface.push_back({slot, face});
    laws.push_back({bodies.body_count() - 1, 0.3});
    return slot;
  }
  /// Begins microsteps of `dt` [s], to be called once all are added.
  void begin(double dt) {
    if (!is_finished) bodies.finish();
    is_finished = true;
    bodies.set_step(dt);
    std::vector<int> flagged;
    bodies.compute_forces();
    bodies.advance(0, flagged);
  }
  /// Does the same with half of the longest stable time, which it returns [s].
  double begin_stable() {
    bodies.finish();
    is_finished = true;
    const double dt = bodies.stable_step(0.5);
    begin(dt);
    return dt;
  }
  Vec3 momentum() const {
    Vec3 sum = Vec3::Zero();
    for (int i = 0; i < bodies.node_count(); ++i) sum += bodies.velocity(i) / bodies.node(i).inverse_mass;
    return sum;
  }
  double kinetic_energy() const {
    double sum = 0;
    for (int i = 0; i < bodies.node_count(); ++i)
      sum += 0.5 * bodies.velocity(i).squaredNorm() / bodies.node(i).inverse_mass;
    return sum;
  }
};

/// Two tets in contact, their placement, the gap between them, and their motion.
struct Pair {
  Corners4 lower, upper;
  Vec3 lower_velocity, upper_velocity;
};

std::vector<Pair> random_pairs(int count) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> number(-1, 1);
  const auto vector = [&] { return Vec3(number(random), number(random), number(random)); };
  std::vector<Pair> pairs(count);
  for (int i = 0; i < count; ++i) {
    Pair& pair = pairs[i];
    const Eigen::AngleAxisd turn(3 * number(random), vector().normalized());
    const Vec3 shift = 10 * i * Vec3::UnitX() + vector();
    const Vec3 gap = 1e-3 * number(random) * Vec3::UnitZ() + 0.8 * (i % 3 == 2) * Vec3::UnitX();
    for (int corner = 0; corner < 4; ++corner) {
      pair.lower[corner] = turn * kLower[corner] + shift;
      pair.upper[corner] = turn * (kUpper[corner] + gap) + shift;
    }
    pair.lower_velocity = vector(), pair.upper_velocity = vector();
  }
  return pairs;
}

/// Resolves one microstep without motion. Returns the velocities of all nodes. `cracked`: the pairs are the sides of
/// cracks, else bodies in collision.
std::vector<Vec3> velocities_after(std::span<const Pair> pairs, bool cracked, double& lost, Vec3& momentum_change) {
  Tets tets;
  std::vector<CrackSides> cracks;
  for (const Pair& pair : pairs) {
    const int lower = tets.add(pair.lower, pair.lower_velocity), upper = tets.add(pair.upper, pair.upper_velocity);
    if (!cracked) continue;
    tets.laws.back().family = tets.laws[tets.laws.size() - 2].family;
    cracks.push_back({lower, upper, {0, 2, 1}, {0, 1, 2}});
  }
  const double dt = 1e-9;
  tets.begin(dt);
  const double energy = tets.kinetic_energy();
  const Vec3 momentum = tets.momentum();
  MicrostepContacts impacts(tets.bodies, tets.surface, cracks, {}, tets.laws, 1);
  impacts.resolve(tets.bodies, dt, 0);
  tets.bodies.compute_forces();
  lost = impacts.lost(tets.bodies, dt) - (energy - tets.kinetic_energy());
  momentum_change = tets.momentum() - momentum;
  std::vector<Vec3> velocities;
  for (int i = 0; i < tets.bodies.node_count(); ++i) velocities.push_back(tets.bodies.velocity(i));
  return velocities;
}

class PairsOfSides : public ::testing::TestWithParam<bool> {};

/// Sides are examined four at a time, and neighbors in that group must not matter.
TEST_P(PairsOfSides, GetTheSameImpulsesAloneAndBesideOthers) {
  const std::vector<Pair> pairs = random_pairs(11);
  double lost = 0;
  Vec3 momentum_change;
  const std::vector<Vec3> together = velocities_after(pairs, GetParam(), lost, momentum_change);
  int pushed = 0, unmoved = 0;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const std::vector<Vec3> alone = velocities_after(std::span(pairs).subspan(i, 1), GetParam(), lost, momentum_change);
    for (int node = 0; node < 8; ++node) EXPECT_EQ(alone[node], together[8 * i + node]) << i;
    (alone[0] == pairs[i].lower_velocity ? unmoved : pushed) += 1;
  }
  EXPECT_GE(pushed, 2);
  EXPECT_GE(unmoved, 2);
}

TEST_P(PairsOfSides, KeepMomentumAndAccountForEnergy) {
  for (int count = 1; count < 10; ++count) {
    double lost = 0;
    Vec3 momentum_change;
    velocities_after(random_pairs(count), GetParam(), lost, momentum_change);
    EXPECT_LT(std::abs(lost), 1e-6);
    EXPECT_LT(momentum_change.norm(), 1e-9);
  }
}

INSTANTIATE_TEST_SUITE_P(OfCracksAndOfBodies, PairsOfSides, ::testing::Bool());

/// Sides of a crack that overlap meet at their center without rebound.
TEST(MicrostepContacts, SidesOfACrackThatCloseStopEachOther) {
  Tets tets;
  Corners4 upper = kUpper;
  for (Vec3& corner : upper) corner.z() -= 1e-4;
  const int first = tets.add(kLower, Vec3(0, 0, 1)), second = tets.add(upper, Vec3(0, 0, -2));
  tets.laws[1].family = tets.laws[0].family;
  tets.begin(1e-9);
  const std::vector<CrackSides> crack = {{first, second, {0, 2, 1}, {0, 1, 2}}};
  MicrostepContacts impacts(tets.bodies, tets.surface, crack, {}, tets.laws, 1);
  impacts.resolve(tets.bodies, 1e-9, 0);
  const auto center_velocity = [&](int node) {
    return Vec3((tets.bodies.velocity(node) + tets.bodies.velocity(node + 1) + tets.bodies.velocity(node + 2)) / 3);
  };
  EXPECT_LT((center_velocity(0) - Vec3(0, 0, -0.5)).norm(), 1e-9);  // equal masses: the mean
  EXPECT_LT((center_velocity(4) - Vec3(0, 0, -0.5)).norm(), 1e-9);
}

/// A ball that rises into the face of a tet from below.
Obstacle ball_below(const Vec3& place) {
  Obstacle ball;
  ball.radius = 0.2;
  ball.inverse_mass = 1e-3;
  ball.inverse_inertia = 0.1 * Mat3::Identity();
  ball.state.pose.translation = place + Vec3(0.3, 0.3, -0.19);
  ball.state.velocity = Vec3(0, 0, 5);
  return ball;
}

/// Returns velocities of nodes after a microstep of tets with a ball under each, `offsets` away from its position in
/// contact.
std::vector<Vec3> struck(std::span<const Vec3> places, std::span<const Vec3> offsets) {
  Tets tets;
  std::vector<Obstacle> balls;
  for (std::size_t i = 0; i < places.size(); ++i) {
    Corners4 corners = kUpper;
    for (Vec3& corner : corners) corner += places[i];
    tets.add(corners, Vec3::Zero());
    balls.push_back(ball_below(places[i] + offsets[i]));
  }
  tets.begin(1e-9);
  MicrostepContacts impacts(tets.bodies, tets.surface, {}, std::move(balls), tets.laws, 1);
  impacts.resolve(tets.bodies, 1e-9, 0);
  std::vector<Vec3> velocities;
  for (int i = 0; i < tets.bodies.node_count(); ++i) velocities.push_back(tets.bodies.velocity(i));
  return velocities;
}

/// The search by position must find all candidates near an obstacle, however many others there are.
TEST(MicrostepContacts, BallsAmongManyTetsStrikeAsThoseAlone) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> number(-1, 1);
  std::vector<Vec3> places, offsets;
  for (int i = 0; i < 64; ++i) {
    places.push_back(4 * Vec3(i % 4, i / 4 % 4, i / 16) + 0.5 * Vec3(number(random), number(random), number(random)));
    offsets.push_back(0.5 * Vec3(number(random), number(random), 0.1 * number(random)));
  }
  const std::vector<Vec3> together = struck(places, offsets);
  int pushed = 0;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const std::vector<Vec3> alone = struck(std::span(places).subspan(i, 1), std::span(offsets).subspan(i, 1));
    for (int node = 0; node < 4; ++node) EXPECT_EQ(alone[node], together[4 * i + node]) << i;
    pushed += !alone[0].isZero(0) || !alone[1].isZero(0);
  }
  EXPECT_GT(pushed, 10);
  EXPECT_LT(pushed, 64);
}

TEST(MicrostepContacts, ObstaclesTouchBodiesOfOtherFamiliesOnly) {
  for (const int family : {-1, 0, 1}) {
    Tets tets;
    Corners4 beside = kUpper;
    for (Vec3& corner : beside) corner += Vec3(-2, 0, 0);
    tets.add(kUpper, Vec3::Zero()), tets.add(beside, Vec3::Zero());
    Obstacle ball = ball_below(Vec3::Zero()), ball_beside = ball_below(Vec3(-2, 0, 0));
    ball.family = ball_beside.family = family;
    tets.begin(1e-9);
    MicrostepContacts impacts(tets.bodies, tets.surface, {}, {ball, ball_beside}, tets.laws, 1);
    impacts.resolve(tets.bodies, 1e-9, 0);
    EXPECT_EQ(tets.bodies.velocity(0).isZero(0), family == 0);
    EXPECT_EQ(tets.bodies.velocity(4).isZero(0), family == 1);
  }
}

/// Tets with an edge along x below, and one along y above it by `gap` [m]. They come together at 2 m/s.
struct CrossingEdges {
  Corners4 lower = {Vec3(-1, 0, 0), Vec3(0.9, 0, 0), Vec3(0, -1, -1), Vec3(0, 1, -1)}, upper;

  explicit CrossingEdges(double gap) {
    upper = {Vec3(0.1, -1, gap), Vec3(0.1, 1, gap), Vec3(-1, 0, gap + 1), Vec3(1, 0, gap + 1)};
  }
  static Vec3 center_of(const Corners4& corners) { return (corners[0] + corners[1] + corners[2] + corners[3]) / 4; }
};

TEST(MicrostepContacts, EdgesOfBodiesDoNotPassEachOther) {
  const CrossingEdges crossing(1e-3);
  Tets tets;
  tets.add(crossing.lower, Vec3(0, 0, 1)), tets.add(crossing.upper, Vec3(0, 0, -1));
  const double dt = tets.begin_stable(), energy = tets.kinetic_energy();
  const Vec3 momentum = tets.momentum();
  MicrostepContacts impacts(tets.bodies, tets.surface, {}, {}, tets.laws, 1);
  std::vector<int> flagged;
  double least = 1;
  for (double time = 0; time < 5e-3; time += dt) {
    tets.bodies.compute_forces();
    tets.bodies.advance(1, flagged);
    impacts.resolve(tets.bodies, dt, 0);
    const auto height = [&](int first) {
      return 0.5 * (tets.bodies.position(first).z() + tets.bodies.position(first + 1).z());
    };
    least = std::min(least, height(4) - height(0));
  }
  EXPECT_GT(least, -2 * dt) << "the way of a microstep [m]";
  EXPECT_LT((tets.momentum() - momentum).norm(), 1e-4 * std::abs(momentum.z()) + 1e-4);
  EXPECT_GT(tets.bodies.velocity(6).z(), tets.bodies.velocity(2).z()) << "they part";
  EXPECT_LT(tets.kinetic_energy(), (1 + 1e-3) * energy);
}

TEST(MicrostepContacts, EdgesOfObstaclesDoNotPassThoseOfBodies) {
  const CrossingEdges crossing(1e-3);
  Tets tets;
  tets.add(crossing.lower, Vec3::Zero());
  const double dt = tets.begin_stable();
  Obstacle obstacle;
  const Vec3 center = CrossingEdges::center_of(crossing.upper);
  std::vector<Vec3> corners;
  for (const Vec3& corner : crossing.upper) corners.push_back(corner - center);
  obstacle.solids = {convex_solid(convex_hull(corners), 1)};
  obstacle.radius = 2;
  obstacle.inverse_mass = 1e-3;
  obstacle.inverse_inertia = 1e-3 * Mat3::Identity();
  obstacle.state.pose.translation = center;
  obstacle.state.velocity = Vec3(0, 0, -2);
  MicrostepContacts impacts(tets.bodies, tets.surface, {}, {obstacle}, tets.laws, 1);
  std::vector<int> flagged;
  for (double time = 0; time < 5e-3; time += dt) {
    tets.bodies.compute_forces();
    tets.bodies.advance(1, flagged);
    impacts.resolve(tets.bodies, dt, 0);
  }
  const double bottom = impacts.obstacles()[0].state.pose.translation.z() - center.z() + 1e-3,
               top = 0.5 * (tets.bodies.position(0).z() + tets.bodies.position(1).z());
  EXPECT_GT(bottom - top, -1e-3);
  EXPECT_GT(impacts.obstacles()[0].state.velocity.z(), -2) << "it was slowed";
}

/// A slab of 2 x 2 x 0.2 m that lies on the plane z = 0, of this mass [kg].
std::vector<Obstacle> slab_on_ground(double mass) {
  Obstacle ground, slab;
  ground.radius = std::numeric_limits<double>::infinity();
  ground.solids = {{{{Vec3::UnitZ(), 0}}, {}, {}}};
  std::vector<Vec3> corners;
  for (int i = 0; i < 8; ++i) corners.emplace_back(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 0.1 : -0.1);
  slab.solids = {convex_solid(convex_hull(corners), 0.5)};
  slab.radius = corners[0].norm();
  slab.inverse_mass = 1 / mass;
  slab.inverse_inertia = 3 / mass * Mat3::Identity();
  slab.state.pose.translation = Vec3(0, 0, 0.1 - 1e-7);
  return {ground, slab};
}

TEST(MicrostepContacts, WhatLiesOnTheGroundIsNotPushedIntoIt) {
  Tets tets;
  Corners4 corners = kUpper;
  for (Vec3& corner : corners) corner.z() += 0.2 - 1e-4;
  tets.add(corners, Vec3(0, 0, -2));
  constexpr double kTime = 1e-6;
  tets.begin(kTime);
  const double before = tets.kinetic_energy();
  MicrostepContacts impacts(tets.bodies, tets.surface, {}, slab_on_ground(100), tets.laws, 1);
  for (int i = 0; i < 1000; ++i) impacts.resolve(tets.bodies, kTime, 0);
  const RigidState& slab = impacts.obstacles()[1].state;
  EXPECT_GT(slab.pose.translation.z(), 0.1 - 1e-6);
  EXPECT_GT(slab.velocity.z(), -1e-6);
  for (int corner = 0; corner < 3; ++corner) EXPECT_GT(tets.bodies.velocity(corner).z(), -1e-3) << "the ground carries";
  EXPECT_NEAR(impacts.lost(tets.bodies, kTime), before - tets.kinetic_energy() - impacts.obstacles()[1].energy_gained,
              1e-6 * before);
}

/// Two fixed walls that meet in a groove along y at the origin, each `slope` [rad] above the horizontal.
std::vector<Obstacle> groove(double slope) {
  std::vector<Obstacle> walls(2);
  for (int side = 0; side < 2; ++side) {
    const double sign = side == 0 ? 1 : -1;
    const Vec3 along(sign * std::cos(slope), 0, std::sin(slope)), below(sign * std::sin(slope), 0, -std::cos(slope));
    std::vector<Vec3> corners;
    for (int i = 0; i < 8; ++i)
      corners.push_back((i & 1 ? 2.0 : -0.2) * along + (i & 2 ? 1.0 : 0.0) * below + (i & 4 ? 1 : -1) * Vec3::UnitY());
    walls[side].solids = {convex_solid(convex_hull(corners), 0.5)};
    walls[side].radius = 3;
    walls[side].friction = 0;
  }
  return walls;
}

/// A node that two faces push at once is pushed too hard by the one that comes first, unless that takes some back. In a
/// flat groove four rounds do not take back all.
TEST(MicrostepContacts, ANodePressedIntoAGrooveHardlyGainsEnergy) {
  constexpr double kOfUnconvergedRounds = 4e-3;
  for (const double slope : {0.3, 0.8, 1.2}) {
    Tets tets;
    Corners4 corners = kLower;
    for (Vec3& corner : corners) corner -= kLower[3] + 1e-2 * Vec3::UnitZ();  // the tip lies in the groove
    constexpr double kWeight = 1e5;
    tets.add(corners, Vec3::Zero(), -kWeight * Vec3::UnitZ());
    const double dt = tets.begin_stable();
    MicrostepContacts impacts(tets.bodies, tets.surface, {}, groove(slope), tets.laws, 1);
    std::vector<int> flagged;
    for (int i = 0; i < 50; ++i) {
      tets.bodies.compute_forces();
      tets.bodies.advance(1, flagged);
      impacts.resolve(tets.bodies, dt, 0);
    }
    tets.bodies.compute_forces();
    const double mass = 4 / tets.bodies.node(0).inverse_mass, fallen = 0.5 * kWeight * 2500 * dt * dt;
    EXPECT_GE(impacts.lost(tets.bodies, dt), -kOfUnconvergedRounds * mass * kWeight * fallen) << slope;
  }
}

/// A corner that slides on a plane and is struck slantwise is moved back along that plane alone.
TEST(MicrostepContacts, ImpulsesMoveNoNodeAgainstItsSupport) {
  Tets tets;
  Corners4 upper = kLower;  // its tip, held, lies in the face of the other
  for (Vec3& corner : upper) corner += Vec3(0.1, 0, 1 - 1e-3);
  tets.add(kLower, Vec3(0.3, 0.2, 1)), tets.add(upper, Vec3::Zero());
  const Vec3 normal = Vec3(1, 2, 3).normalized();
  constexpr int kTip = 7;
  tets.bodies.constrain(kTip, NodeConstraint::sliding(normal));
  const double dt = tets.begin_stable();
  MicrostepContacts impacts(tets.bodies, tets.surface, {}, {}, tets.laws, 1);
  const Vec3 before = tets.bodies.position(kTip);
  impacts.resolve(tets.bodies, dt, 0);
  EXPECT_GT((tets.bodies.position(kTip) - before).norm(), 1e-9) << "it was pushed";
  EXPECT_LT(std::abs(normal.dot(tets.bodies.position(kTip) - before)), 1e-15);
}

TEST(MicrostepContacts, NothingIsInsideAHullOfPointsInALine) {
  for (const int count : {1, 2, 5}) {
    std::vector<Vec3> points;
    for (int i = 0; i < count; ++i) points.emplace_back(i, 2 * i, 0);
    EXPECT_GT(convex_solid(convex_hull(points), 1).outermost_face(Vec3(1, 2, 0)).first, 0) << count;
  }
}

}  // namespace
}  // namespace griffith::explicit_dynamics
