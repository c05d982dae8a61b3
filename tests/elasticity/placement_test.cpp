#include "sim/elasticity/placement.h"

#include <gtest/gtest.h>

#include <vector>

#include "tests/random_values.h"

namespace griffith {
namespace {

using testing::RandomValues;

/// Random points, and the nodes of all of them but the last, which is elsewhere.
struct Cloud {
  explicit Cloud(RandomValues& random) {
    for (int i = 0; i < 9; ++i) {
      rest.push_back(random.vector());
      weights.push_back(random.uniform(0.5, 2));
      if (i < 8) nodes.emplace_back(i);
    }
    now = rest;
  }

  Placement placement() const { return best_placement(rest, now, weights, nodes); }
  double squares(const Placement& placement) const {
    double sum = 0;
    for (const NodeId node : nodes) sum += weights[node] * (placement.to_world(rest[node]) - now[node]).squaredNorm();
    return sum;
  }

  std::vector<Vec3> rest, now;
  std::vector<double> weights;
  std::vector<NodeId> nodes;
};

TEST(Placement, OfARigidMotionIsThatMotion) {
  RandomValues random(1);
  for (int trial = 0; trial < 20; ++trial) {
    Cloud cloud(random);
    const Mat3 turn = random.rotation();
    const Vec3 shift = 10 * random.vector();
    for (const NodeId node : cloud.nodes) cloud.now[node] = turn * cloud.rest[node] + shift;
    const Placement placement = cloud.placement();
    EXPECT_LT((placement.turn - turn).norm(), 1e-12);
    for (const NodeId node : cloud.nodes)
      EXPECT_LT((placement.to_world(cloud.rest[node]) - cloud.now[node]).norm(), 1e-12);
  }
}

TEST(Placement, IsCloserThanOthersNearIt) {
  RandomValues random(2);
  for (int trial = 0; trial < 20; ++trial) {
    Cloud cloud(random);
    for (const NodeId node : cloud.nodes) cloud.now[node] += 0.2 * random.vector();
    const Placement best = cloud.placement();
    for (int other = 0; other < 20; ++other) {
      Placement moved = best;
      moved.center += 1e-3 * random.vector();
      moved.turn = moved.turn * Eigen::AngleAxisd(1e-3, random.direction()).toRotationMatrix();
      EXPECT_GT(cloud.squares(moved), cloud.squares(best));
    }
  }
}

TEST(Placement, FollowsTheWeights) {
  RandomValues random(3);
  Cloud cloud(random);
  const Mat3 turn = random.rotation();
  for (const NodeId node : cloud.nodes) {
    cloud.weights[node] = node.index() < 4 ? 1e8 : 1;
    cloud.now[node] = node.index() < 4 ? Vec3(turn * cloud.rest[node]) : random.vector();
  }
  EXPECT_LT((cloud.placement().turn - turn).norm(), 1e-6);
}

TEST(Placement, OfASinglePointIsATurnAllTheSame) {
  RandomValues random(4);
  Cloud cloud(random);
  cloud.nodes.resize(1);
  const Placement placement = cloud.placement();
  EXPECT_LT((placement.turn.transpose() * placement.turn - Mat3::Identity()).norm(), 1e-12);
  EXPECT_LT((placement.to_world(cloud.rest[0]) - cloud.now[0]).norm(), 1e-12);
}

}  // namespace
}  // namespace griffith
