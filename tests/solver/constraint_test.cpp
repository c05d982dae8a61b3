#include <gtest/gtest.h>

#include "sim/solver/explicit_step.h"
#include "tests/random_values.h"
#include "tests/solver/elastic_box.h"

namespace griffith {
namespace {

using testing::ElasticBox;
using testing::RandomValues;

constexpr ImplicitStep kTight{.dt = 0.05, .relative_residual = 1e-12, .max_iterations = 2000};
const Vec3 kGravity(0, -9.81, 0);

/// A box whose bottom nodes are constrained alike.
ElasticBox box_on(const NodeConstraint& base) {
  ElasticBox body(Vec3(1, 1, 1), 0.25, 1e7);
  for (std::size_t i = 0; i < body.constraints.size(); ++i)
    if (body.positions[i].y() < -0.499) body.constraints[i] = base;
  return body;
}

void advance(ElasticBox& body, ElasticSystem& system, const ImplicitStep& step) {
  body.update_states();
  for (std::size_t i = 0; i < body.forces.size(); ++i) body.forces[i] = body.masses[i] * kGravity;
  body.add_elastic_forces();
  body.assemble(system, step);
  EXPECT_TRUE(body.solve(system, step).converged);
  for (std::size_t i = 0; i < body.positions.size(); ++i) body.positions[i] += step.dt * body.velocities[i];
}

Vec3 sum(std::span<const Vec3> vectors) {
  Vec3 total = Vec3::Zero();
  for (const Vec3& v : vectors) total += v;
  return total;
}

double total_mass(const ElasticBox& body) {
  double mass = 0;
  for (double m : body.masses) mass += m;
  return mass;
}

TEST(NodeConstraint, BlocksWhatItIsToldAndLeavesTheRest) {
  RandomValues random(1);
  for (int trial = 0; trial < 100; ++trial) {
    const Vec3 first = random.direction(), second = random.direction(), third = random.direction();
    NodeConstraint constraint = NodeConstraint::sliding(3 * first, 1);
    constraint.block(second, -2);
    EXPECT_EQ(constraint.blocked, 2);
    const Vec3 v = constraint.velocity + constraint.allowed * random.vector();
    EXPECT_NEAR(first.dot(v), 1, 1e-9);
    EXPECT_NEAR(second.dot(v), -2, 1e-9);
    EXPECT_LT((constraint.allowed * constraint.allowed - constraint.allowed).norm(), 1e-12);
    EXPECT_LT((constraint.allowed * constraint.velocity).norm(), 1e-9);
    constraint.block(first + second, 5);  // follows from the two: changes nothing
    EXPECT_EQ(constraint.blocked, 2);
    constraint.block(third, 0.5);
    EXPECT_TRUE(constraint.is_held());
    EXPECT_NEAR(third.dot(constraint.velocity), 0.5, 1e-7);
    EXPECT_NEAR(first.dot(constraint.velocity), 1, 1e-7);
    EXPECT_EQ(constraint.allowed, Mat3(Mat3::Zero()));
  }
}

TEST(Constraints, ReactionsOfAFixedBaseCarryTheWeight) {
  ElasticBox body = box_on(NodeConstraint::held());
  ElasticSystem system = body.system();
  for (int n = 0; n < 400; ++n) advance(body, system, kTight);
  EXPECT_LT((sum(system.reaction_forces()) + total_mass(body) * kGravity).norm(), 1e-6 * total_mass(body) * 9.81);
}

TEST(Constraints, ABodyHeldWhollyMovesAsItIsToldAndItsSupportsCarryIt) {
  ElasticBox body(Vec3(1, 1, 1), 0.5, 1e9);
  const Vec3 velocity(1, -2, 3), gravity(0, -9.81, 0);
  std::ranges::fill(body.constraints, NodeConstraint::held(velocity));
  std::ranges::fill(body.velocities, velocity);
  Vec3 weight = Vec3::Zero(), carried = Vec3::Zero();
  for (std::size_t i = 0; i < body.forces.size(); ++i) weight += body.forces[i] = body.masses[i] * gravity;
  ElasticSystem system = body.system();
  body.assemble(system, {.dt = 0.01});
  EXPECT_EQ(system.nodes().size(), 0u);
  EXPECT_TRUE(body.solve(system, {.dt = 0.01}).converged);
  for (const Vec3& v : body.velocities) EXPECT_EQ(v, velocity);
  for (const Vec3& force : system.reaction_forces()) carried += force;
  EXPECT_LT((carried + weight).norm(), 1e-9 * weight.norm());
  EXPECT_EQ(highest_frequency(system.matrix(), Eigen::VectorXd()), 0);
}

TEST(Constraints, AMovingBodyBalancesItsMomentum) {
  RandomValues random(2);
  NodeConstraint base = NodeConstraint::sliding(Vec3(1, 2, 0.5), 0.3);
  ElasticBox body = box_on(base);
  body.constraints.back() = NodeConstraint::held(Vec3(0.1, 0.2, -0.4));
  body.constraints.front().block(Vec3(0, 0, 1), -0.1);
  ElasticSystem system = body.system();
  const auto momentum = [&] {
    Vec3 total = Vec3::Zero();
    for (std::size_t i = 0; i < body.masses.size(); ++i) total += body.masses[i] * body.velocities[i];
    return total;
  };
  for (Vec3& velocity : body.velocities) velocity = random.vector();
  for (int n = 0; n < 20; ++n) {
    const Vec3 before = momentum();
    advance(body, system, kTight);
    const Vec3 force = sum(system.reaction_forces()) + total_mass(body) * kGravity;
    EXPECT_LT((momentum() - before - kTight.dt * force).norm(), 1e-8 * force.norm() * kTight.dt);
    for (NodeId node : system.supports()) {
      const NodeConstraint& constraint = body.constraints[node];
      EXPECT_LT((body.velocities[node] - constraint.allowed * body.velocities[node] - constraint.velocity).norm(),
                1e-12);
    }
  }
}

TEST(Constraints, ReactionsOfASlidingBaseAreNormalToIt) {
  const Vec3 normal = Vec3(1, 3, -1).normalized();
  ElasticBox body = box_on(NodeConstraint::sliding(normal));
  ElasticSystem system = body.system();
  for (int n = 0; n < 5; ++n) {
    advance(body, system, kTight);
    for (const Vec3& reaction : system.reaction_forces())
      EXPECT_LT(reaction.cross(normal).norm(), 1e-9 * total_mass(body));
  }
}

TEST(Constraints, ABodySlidesDownAFrictionlessRampAsAWhole) {
  // Without deformation, the acceleration is the part of gravity along the ramp; a stiff body is all but rigid.
  const Vec3 normal = Vec3(0.5, 1, 0).normalized();
  ElasticBox body(Vec3(1, 1, 1), 0.25, 1e12);
  for (std::size_t i = 0; i < body.constraints.size(); ++i)
    if (body.positions[i].y() < -0.499) body.constraints[i] = NodeConstraint::sliding(normal);
  ElasticSystem system = body.system();
  for (int n = 0; n < 10; ++n) advance(body, system, kTight);
  const Vec3 expected = 10 * kTight.dt * (kGravity - kGravity.dot(normal) * normal);
  for (const Vec3& velocity : body.velocities) EXPECT_LT((velocity - expected).norm(), 1e-4);
}

TEST(Constraints, PrescribedEndsStretchABarUniformly) {
  ElasticBox body(Vec3(4, 1, 1), 0.5, 1e7);
  body.material.poisson_ratio = 0;
  const double speed = 0.01;
  for (std::size_t i = 0; i < body.constraints.size(); ++i) {
    const double x = body.positions[i].x();
    if (std::abs(x) > 1.999) body.constraints[i] = NodeConstraint::held(Vec3(x > 0 ? speed : -speed, 0, 0));
  }
  ElasticSystem system = body.system();
  const ImplicitStep slow{.dt = 1, .relative_residual = 1e-12, .max_iterations = 2000};  // quasistatic
  for (int n = 0; n < 10; ++n) {
    body.update_states();
    std::fill(body.forces.begin(), body.forces.end(), Vec3::Zero());
    body.add_elastic_forces();
    body.assemble(system, slow);
    body.solve(system, slow);
    for (std::size_t i = 0; i < body.positions.size(); ++i) body.positions[i] += slow.dt * body.velocities[i];
  }
  body.update_states();
  const double stress = 1e7 * 10 * 2 * speed / 4;
  for (TetId tet : body.tets) EXPECT_NEAR(body.states[tet].stress.full()(0, 0), stress, 1e-3 * stress);
  double pull = 0;
  for (std::size_t i = 0; i < system.supports().size(); ++i) pull += 0.5 * std::abs(system.reaction_forces()[i].x());
  EXPECT_NEAR(pull, stress, 1e-3 * stress) << "on a cross-section of 1 m²";
}

TEST(Constraints, KeepTheMatrixSymmetricPositiveDefinite) {
  ElasticBox body = box_on(NodeConstraint::sliding(Vec3(1, 2, 3)));
  body.constraints.back() = NodeConstraint::held();
  ElasticSystem system = body.system();
  body.assemble(system, kTight);
  const BlockSparseMatrix& a = system.matrix();
  RandomValues random(3);
  for (int trial = 0; trial < 20; ++trial) {
    NodeVectors u(3, a.rows()), v(3, a.rows()), au, av;
    for (int i = 0; i < a.rows(); ++i) u.col(i) = random.vector(), v.col(i) = random.vector();
    multiply(a, u, au);
    multiply(a, v, av);
    EXPECT_NEAR(dot(u, av), dot(v, au), 1e-10 * std::abs(dot(u, au)));
    EXPECT_GT(dot(u, au), 0);
  }
}

}  // namespace
}  // namespace griffith
