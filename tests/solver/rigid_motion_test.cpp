#include "sim/solver/rigid_motion.h"

#include <gtest/gtest.h>

#include "tests/random_values.h"

namespace griffith {
namespace {

/// Random nodes: positions [m], velocities [m/s] and masses [kg].
struct Nodes {
  NodeVectors positions, velocities;
  Eigen::VectorXd masses;

  RigidMotion motion() const { return rigid_motion(positions, velocities, masses); }
};

Nodes random_nodes(testing::RandomValues& random, Eigen::Index count) {
  Nodes nodes{NodeVectors(3, count), NodeVectors(3, count), Eigen::VectorXd(count)};
  for (Eigen::Index i = 0; i < count; ++i) {
    for (int axis = 0; axis < 3; ++axis) {
      nodes.positions(axis, i) = random.uniform(-1, 1);
      nodes.velocities(axis, i) = random.uniform(-1, 1);
    }
    nodes.masses[i] = random.uniform(0.1, 2);
  }
  return nodes;
}

/// All nodes of two bodies.
Nodes all_of(const Nodes& a, const Nodes& b) {
  const Eigen::Index count = a.masses.size() + b.masses.size();
  Nodes nodes{NodeVectors(3, count), NodeVectors(3, count), Eigen::VectorXd(count)};
  nodes.positions << a.positions, b.positions;
  nodes.velocities << a.velocities, b.velocities;
  nodes.masses << a.masses, b.masses;
  return nodes;
}

TEST(JoinedMotion, IsThatOfAllNodes) {
  testing::RandomValues random(1);
  for (int round = 0; round < 100; ++round) {
    const Nodes a = random_nodes(random, 6), b = random_nodes(random, 9);
    const RigidMotion joined = joined_motion(a.motion(), b.motion()), all = all_of(a, b).motion();
    EXPECT_NEAR(joined.mass, all.mass, 1e-12);
    EXPECT_LT((joined.center - all.center).norm(), 1e-12);
    EXPECT_LT((joined.inertia - all.inertia).norm(), 1e-11);
    EXPECT_LT((joined.velocity - all.velocity).norm(), 1e-12);
    EXPECT_LT((joined.angular_velocity - all.angular_velocity).norm(), 1e-11);
  }
}

}  // namespace
}  // namespace griffith
