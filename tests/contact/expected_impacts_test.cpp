#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "tests/contact/bodies.h"
#include "tests/random_values.h"

namespace griffith {
namespace {

using namespace testing;

constexpr double kStep = 1.0 / 60, kTimeError = 1e-5;  // [s]
constexpr double kMetOverlap = 1e-9, kMetGap = 6e-4;   // of surfaces that meet; the latter in the time error [m]
constexpr int kSamples = 500;                          // of a step
const Vec3 kGravity(0, -9.81, 0);

/// A box in free flight, as a step of that length would take it.
struct FlyingBox {
  Vec3 size;
  RigidState start;

  Pose pose(double time) const {
    const Vec3 turn = time * start.angular_velocity;
    const Quat rotation(Eigen::AngleAxisd(turn.norm(), turn.normalized()));
    return {start.pose.translation + time * (start.velocity + time * kGravity), rotation * start.pose.rotation};
  }
  std::vector<Vec3> corners(double time) const {
    std::vector<Vec3> corners;
    for (const Vec3& corner : box_part(size)) corners.push_back(pose(time).to_world(corner));
    return corners;
  }
  double height(double time) const {
    double height = std::numeric_limits<double>::infinity();
    for (const Vec3& corner : corners(time)) height = std::min(height, corner.y());
    return height;
  }
};

/// Returns the distance of two boxes along the best separating axis (Gottschalk 1996); negative if they overlap.
double gap_between(const FlyingBox& a, const FlyingBox& b, double time) {
  const Mat3 of_a = a.pose(time).rotation.toRotationMatrix(), of_b = b.pose(time).rotation.toRotationMatrix();
  std::vector<Vec3> axes;
  for (int i = 0; i < 3; ++i) {
    axes.push_back(of_a.col(i)), axes.push_back(of_b.col(i));
    for (int j = 0; j < 3; ++j) axes.push_back(of_a.col(i).cross(of_b.col(j)));
  }
  const Vec3 apart = a.pose(time).translation - b.pose(time).translation;
  double gap = -std::numeric_limits<double>::infinity();
  for (const Vec3& axis : axes) {
    if (axis.norm() < 1e-6) continue;
    const Vec3 unit = axis.normalized();
    const double reach =
        0.5 * ((of_a.transpose() * unit).cwiseAbs().dot(a.size) + (of_b.transpose() * unit).cwiseAbs().dot(b.size));
    gap = std::max(gap, std::abs(unit.dot(apart)) - reach);
  }
  return gap;
}

FlyingBox random_box(RandomValues& random, const Vec3& place) {
  FlyingBox box{Vec3::Constant(0.25) + random.vector(0.2), at(place, random.vector(8))};
  box.start.pose.rotation = Quat(random.rotation());
  box.start.angular_velocity = random.vector(20);
  return box;
}

ProxyId add(ContactWorld& world, const FlyingBox& box) {
  const ProxyId proxy = world.add_proxy(box_parts(box.size), box_mass(box.size, 1), Mobility::free, box.start, {});
  world.set_impact_speed(proxy, 0);
  return proxy;
}

/// Neither later than the surfaces meet nor while they are apart.
template <class Gap>
void expect_time_of_meeting(const std::vector<ContactWorld::Encounter>& impacts, Gap gap, int seed) {
  const double end = impacts.empty() ? kStep : impacts.front().time;
  for (int i = 0; i <= kSamples; ++i) EXPECT_GT(gap(end * i / kSamples), -kMetOverlap) << seed << " at " << i;
  if (!impacts.empty()) {
    EXPECT_LT(gap(end), kMetGap) << seed;
  }
}

TEST(ExpectedImpacts, BoxesThatTumbleReachTheGroundWhenTheirCornersDo) {
  RandomValues random(1);
  int met = 0;
  for (int seed = 0; seed < 300; ++seed) {
    FlyingBox box = random_box(random, Vec3::Zero());
    box.start.pose.translation.y() = random.uniform(0, 0.15) - box.height(0);
    ContactWorld world(kGravity);
    world.add_ground(0, {});
    add(world, box);
    world.detect();
    const auto impacts = world.expected_impacts(kStep, 0.1, kTimeError);
    met += !impacts.empty();
    const auto speed = [&](double time) { return (box.height(time) - box.height(time + 1e-6)) / 1e-6; };
    if (impacts.empty() && speed(kStep) < 0.2) continue;  // may touch, too slow to count
    expect_time_of_meeting(
        impacts, [&](double time) { return box.height(time); }, seed);
    if (impacts.empty()) continue;
    EXPECT_GT(impacts.front().approach, speed(impacts.front().time) - 0.2) << seed;
  }
  EXPECT_GT(met, 60);
  EXPECT_LT(met, 240);
}

TEST(ExpectedImpacts, BoxesThatTumbleMeetWhenTheirSurfacesDo) {
  RandomValues random(2);
  int met = 0;
  for (int seed = 0; seed < 300; ++seed) {
    const Vec3 way = random.direction();
    const FlyingBox a = random_box(random, Vec3::Zero());
    FlyingBox b = random_box(random, 0.5 * way);
    b.start.velocity -= 8 * way;
    if (gap_between(a, b, 0) < kMetGap) continue;
    ContactWorld world(kGravity);
    add(world, a), add(world, b);
    world.detect();
    const auto impacts = world.expected_impacts(kStep, 0.1, kTimeError);
    met += !impacts.empty();
    expect_time_of_meeting(
        impacts, [&](double time) { return gap_between(a, b, time); }, seed);
  }
  EXPECT_GT(met, 40);
}

TEST(ExpectedImpacts, WhatSpinsFlatAboveTheGroundOrOnItStrikesNothing) {
  for (const double height : {0.0, 1e-5, 1e-3}) {
    FlyingBox plate{Vec3(1, 0.02, 1), at(Vec3(0, 0.01 + height, 0))};
    plate.start.angular_velocity = Vec3(0, 30, 0);
    ContactWorld world(kGravity);
    world.add_ground(0, {});
    add(world, plate);
    world.detect();
    EXPECT_TRUE(world.expected_impacts(kStep, 2 * 9.81 * kStep, kTimeError).empty()) << height;
  }
}

TEST(ExpectedImpacts, WhatTipsOverAnEdgeStrikesWithTheOther) {
  FlyingBox plank{Vec3(2, 0.1, 0.1), at(Vec3(0, 0, 0))};
  plank.start.pose.rotation = Quat(Eigen::AngleAxisd(0.02, Vec3::UnitZ()));
  plank.start.pose.translation.y() = -plank.height(0);
  plank.start.angular_velocity = Vec3(0, 0, -3);
  plank.start.velocity = Vec3(0, -3 * 0.99, 0);  // the low edge stands still
  ContactWorld world(kGravity);
  world.add_ground(0, {});
  add(world, plank);
  world.detect();
  const auto impacts = world.expected_impacts(kStep, 0.5, kTimeError);
  ASSERT_EQ(impacts.size(), 1u);
  EXPECT_NEAR(impacts.front().approach, 3 * 2 + 9.81 * kStep, 0.2);
}

}  // namespace
}  // namespace griffith
