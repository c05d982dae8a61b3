#include <gtest/gtest.h>

#include "tests/contact/bodies.h"

namespace griffith {
namespace {

using namespace testing;

const Vec3 kSize(1, 1, 1);  // 8.7 mm of reach

/// Cubes in a row along x with these gaps between them and these velocities, weightless.
struct Row {
  Row(const std::vector<double>& gaps, const std::vector<double>& velocities) : world(Vec3::Zero()) {
    double x = 0;
    for (std::size_t i = 0; i < velocities.size(); ++i) {
      cubes.push_back(world.add_proxy(box_parts(kSize), box_mass(kSize, 1), Mobility::free,
                                      at(Vec3(x, 0, 0), Vec3(velocities[i], 0, 0)), {0.5, 0}));
      if (i < gaps.size()) x += 1 + gaps[i];
    }
    world.detect();
  }

  std::vector<double> approach() const {
    std::vector<double> speeds;
    for (const Contact& contact : world.contacts())
      speeds.push_back(-contact.normal.dot(world.state(contact.a).velocity - world.state(contact.b).velocity));
    return speeds;
  }

  /// Returns the number of contacts left for each gap.
  std::vector<int> left() const {
    std::vector<int> count(cubes.size() - 1, 0);
    for (const Contact& contact : world.contacts()) ++count[std::min(contact.a, contact.b)];
    return count;
  }

  ContactWorld world;
  std::vector<ProxyId> cubes;
};

TEST(NearMisses, OnlyGapsThatMayCloseStay) {
  Row row({0.005, 0.005, -0.001}, {0.7, 0, 0.3, 0.3});
  ASSERT_EQ(row.left(), (std::vector<int>{4, 4, 4}));
  const std::vector<int> index = row.world.drop_near_misses(kDt, row.approach());
  EXPECT_EQ(row.left(), (std::vector<int>{4, 0, 4})) << "the second gap widens, the third overlaps";
  EXPECT_EQ(std::count(index.begin(), index.end(), -1), 4);
  int next = 0;
  for (int i : index) {
    if (i >= 0) {
      EXPECT_EQ(i, next++) << "those that stay keep their order";
    }
  }
}

TEST(NearMisses, WhatAnImpactSetsInMotionStays) {
  Row row({0.001, 0.005}, {2, 0, 0});
  row.world.drop_near_misses(kDt, row.approach());
  EXPECT_EQ(row.left(), (std::vector<int>{4, 4}));
}

TEST(NearMisses, WhatPushedLastTimeStays) {
  Row row({-0.001}, {0, 0});
  row.world.set_velocity(row.cubes[0], Vec3(0.5, 0, 0), Vec3::Zero());  // it is pressed on for the whole of the substep
  row.world.solve(kDt);
  row.world.advance(kDt);
  row.world.set_state(row.cubes[1], at(Vec3(1.004, 0, 0)));
  row.world.set_velocity(row.cubes[0], Vec3::Zero(), Vec3::Zero());
  row.world.detect();
  row.world.drop_near_misses(kDt, row.approach());
  EXPECT_EQ(row.left(), std::vector<int>{4});
}

TEST(NearMisses, ThoseLeftOutWouldNotHavePushed) {
  for (int seed = 0; seed < 20; ++seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> gap(0.0, 0.008), speed(-0.5, 0.5);
    std::vector<double> gaps, velocities(8);
    for (double& velocity : velocities) velocity = speed(random);
    for (int i = 0; i < 7; ++i) gaps.push_back(gap(random));
    Row all(gaps, velocities), some(gaps, velocities);
    some.world.drop_near_misses(kDt, some.approach());
    for (Row* row : {&all, &some}) {
      row->world.solve(kDt);
      row->world.advance(kDt);
    }
    for (ProxyId cube : all.cubes)
      EXPECT_LT((all.world.state(cube).velocity - some.world.state(cube).velocity).norm(), 0.01) << seed;
  }
}

}  // namespace
}  // namespace griffith
