#include "sim/solver/elastic_system.h"

#include <gtest/gtest.h>

#include "sim/solver/rigid_motion.h"
#include "tests/random_values.h"
#include "tests/solver/elastic_box.h"

namespace griffith {
namespace {

using testing::ElasticBox;
using testing::RandomValues;

Vec3 momentum(const ElasticBox& body) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = 0; i < body.masses.size(); ++i) sum += body.masses[i] * body.velocities[i];
  return sum;
}

Vec3 angular_momentum(const ElasticBox& body) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = 0; i < body.masses.size(); ++i)
    sum += body.masses[i] * body.positions[i].cross(body.velocities[i]);
  return sum;
}

TEST(ElasticSystem, FreeFallIsExactAtEveryStiffness) {
  for (double young_modulus : {1e4, 1e6, 1e9, 4e11}) {
    ElasticBox body(Vec3(2, 1, 1), 0.25, young_modulus);
    ElasticSystem system = body.system();
    const Vec3 gravity(0, -9.81, 0), start(1, 2, 3);
    body.velocities.assign(body.positions.size(), start);
    const ImplicitStep step{.dt = 1.0 / 60, .relative_residual = 1e-2, .max_iterations = 5};
    for (int n = 1; n <= 60; ++n) {
      body.update_states();
      for (std::size_t i = 0; i < body.forces.size(); ++i) body.forces[i] = body.masses[i] * gravity;
      body.add_elastic_forces();
      body.assemble(system, step);
      body.solve(system, step);
      for (std::size_t i = 0; i < body.positions.size(); ++i) body.positions[i] += step.dt * body.velocities[i];
    }
    const double t = 1;
    const Vec3 fallen = start * t + 0.5 * gravity * t * (t + step.dt);
    for (std::size_t i = 0; i < body.positions.size(); ++i)
      EXPECT_LT((body.positions[i] - body.mesh.rest_positions[i] - fallen).norm(), 1e-9) << "E = " << young_modulus;
  }
}

TEST(ElasticSystem, MomentumIsExactWhateverResidualIsLeft) {
  RandomValues random(1);
  ElasticBox body(Vec3(2, 1, 1), 0.25, 1e9);
  ElasticSystem system = body.system();
  const ImplicitStep step{.dt = 1.0 / 120, .stiffness_damping = 1e-3, .max_iterations = 2};
  for (Vec3& velocity : body.velocities) velocity = random.vector();
  for (int n = 0; n < 50; ++n) {
    body.update_states();
    Vec3 resultant = Vec3::Zero(), torque = Vec3::Zero();
    for (std::size_t i = 0; i < body.forces.size(); ++i) {
      body.forces[i] = random.vector(10);
      resultant += body.forces[i];
      torque += body.positions[i].cross(body.forces[i]);
    }
    body.add_elastic_forces();
    const Vec3 expected = momentum(body) + step.dt * resultant;
    const Vec3 expected_angular = angular_momentum(body) + step.dt * torque;
    body.assemble(system, step);
    body.solve(system, step);
    EXPECT_LT((momentum(body) - expected).norm(), 1e-9 * (1 + expected.norm()));
    EXPECT_LT((angular_momentum(body) - expected_angular).norm(), 1e-9 * (1 + expected_angular.norm()));
    for (std::size_t i = 0; i < body.positions.size(); ++i) body.positions[i] += step.dt * body.velocities[i];
  }
}

TEST(ElasticSystem, ImplicitEulerNeverGainsEnergy) {
  ElasticBox body(Vec3(4, 1, 1), 0.5, 1e6);
  body.material.poisson_ratio = 0;
  ElasticSystem system = body.system();
  const ImplicitStep tight{.dt = 1e-3, .relative_residual = 1e-12, .max_iterations = 2000};

  for (std::size_t i = 0; i < body.velocities.size(); ++i)
    body.velocities[i] = Vec3(body.positions[i].x() > 0 ? 1 : -1, 0, 0);
  const auto energy = [&] {
    double sum = 0;
    body.update_states();
    for (std::size_t i = 0; i < body.masses.size(); ++i) sum += 0.5 * body.masses[i] * body.velocities[i].squaredNorm();
    for (TetId tet : body.tets) sum += body.rest_elements[tet].volume * body.states[tet].energy_density;
    return sum;
  };
  double previous = energy();
  for (int n = 0; n < 100; ++n) {
    std::fill(body.forces.begin(), body.forces.end(), Vec3::Zero());
    body.add_elastic_forces();
    body.assemble(system, tight);
    body.solve(system, tight);
    for (std::size_t i = 0; i < body.positions.size(); ++i) body.positions[i] += tight.dt * body.velocities[i];
    const double now = energy();
    EXPECT_LE(now, previous * (1 + 1e-9)) << "implicit Euler never gains energy";
    previous = now;
  }
}

TEST(ElasticSystem, KeepsItsMatrixUntilWhatItIsMadeOfChanges) {
  ElasticBox body(Vec3(2, 1, 1), 0.5, 1e8);
  ElasticSystem system = body.system();
  ImplicitStep step{.dt = 0.01};
  std::vector<Mat3> kept;
  const auto changes = [&] {
    body.update_states();
    body.assemble(system, step);
    const bool changed = kept != system.matrix().blocks;
    kept = system.matrix().blocks;
    return changed;
  };
  const auto turn = [&](double angle) {
    const Mat3 rotation = Eigen::AngleAxisd(angle, Vec3::UnitZ()).toRotationMatrix();
    for (Vec3& position : body.positions) position = rotation * position;
  };
  EXPECT_TRUE(changes());
  turn(3e-5);
  EXPECT_FALSE(changes());
  // Small turns add up, since they are counted from where the matrix was made.
  turn(1e-4);
  EXPECT_TRUE(changes());
  step.dt = 0.02;
  EXPECT_TRUE(changes());
  body.masses[0] *= 2;
  EXPECT_TRUE(changes());
  body.material.young_modulus *= 2;
  EXPECT_TRUE(changes());
  EXPECT_FALSE(changes());
}

TEST(ElasticSystem, HeldNodesStayAndSupportTheRest) {
  ElasticBox body(Vec3(2, 1, 1), 0.5, 1e8);
  for (std::size_t i = 0; i < body.constraints.size(); ++i)
    if (body.positions[i].x() < -0.99) body.constraints[i] = NodeConstraint::held();
  ElasticSystem system = body.system();
  EXPECT_FALSE(system.is_free());
  const ImplicitStep step{.dt = 0.05, .relative_residual = 1e-10, .max_iterations = 1000};
  for (int n = 0; n < 400; ++n) {
    body.update_states();
    for (std::size_t i = 0; i < body.forces.size(); ++i) body.forces[i] = body.masses[i] * Vec3(0, -9.81, 0);
    body.add_elastic_forces();
    body.assemble(system, step);
    body.solve(system, step);
    for (NodeId node : system.nodes()) body.positions[node] += step.dt * body.velocities[node];
  }
  // At rest the elastic forces of the free nodes balance gravity.
  body.update_states();
  for (std::size_t i = 0; i < body.forces.size(); ++i) body.forces[i] = body.masses[i] * Vec3(0, -9.81, 0);
  body.add_elastic_forces();
  for (NodeId node : system.nodes()) EXPECT_LT(body.forces[node].norm(), 1e-3 * body.masses[node] * 9.81);
  for (std::size_t i = 0; i < body.constraints.size(); ++i) {
    if (body.constraints[i].is_held()) {
      EXPECT_EQ(body.positions[i], body.mesh.rest_positions[i]);
    }
  }
}

/// Returns the velocities that deform a stretched box in a step after which it is at rest in axes that spin with it.
NodeVectors relaxing_velocities(const Vec3& spin) {
  ElasticBox body(Vec3(1, 0.6, 0.4), 0.2, 1e10);
  const Mat3 stretch{{1.01, 0.004, 0}, {0.004, 0.99, 0.002}, {0, 0.002, 1}};
  for (Vec3& position : body.positions) position = stretch * position;
  for (const Vec3& position : body.positions) body.velocities[&position - body.positions.data()] = spin.cross(position);
  body.update_states();
  body.add_elastic_forces();
  ElasticSystem system = body.system();
  const ImplicitStep step{.dt = 1.0 / 60, .relative_residual = 1e-8, .max_iterations = 2000};
  body.assemble(system, step);
  EXPECT_TRUE(body.solve(system, step).converged);
  const NodeVectors places = system.gather(body.positions), velocities = system.gather(body.velocities);
  const RigidMotion motion = rigid_motion(places, velocities, system.gather_masses(body.masses, {}));
  NodeVectors deforming = velocities;
  for (Eigen::Index i = 0; i < deforming.cols(); ++i) deforming.col(i) -= motion.velocity_at(places.col(i));
  return deforming;
}

/// Axes that spin along see the same strain. A stiffness that resists displacements along tangents would take the spin
/// of a strained body for strain, and strain for spin.
TEST(ElasticSystem, AStretchedBodyRelaxesAlikeWhetherItSpinsOrNot) {
  const NodeVectors still = relaxing_velocities(Vec3::Zero());
  for (const Vec3& spin : {Vec3(8, 0, 0), Vec3(0, -3, 6), Vec3(5, 5, 5)}) {
    const NodeVectors spinning = relaxing_velocities(spin);
    EXPECT_LT((spinning - still).norm(), 0.01 * still.norm()) << spin.transpose();
  }
  EXPECT_GT(still.norm(), 1);
}

TEST(RigidMotion, RecoversARigidVelocityField) {
  RandomValues random(5);
  for (int trial = 0; trial < 50; ++trial) {
    const Vec3 velocity = random.vector(), angular_velocity = random.vector();
    NodeVectors positions(3, 6), velocities(3, 6);
    Eigen::VectorXd masses(6);
    for (int i = 0; i < 6; ++i) {
      positions.col(i) = random.vector();
      velocities.col(i) = velocity + angular_velocity.cross(Vec3(positions.col(i)));
      masses[i] = random.uniform(0.1, 2);
    }
    const RigidMotion motion = rigid_motion(positions, velocities, masses);
    EXPECT_LT((motion.angular_velocity - angular_velocity).norm(), 1e-10);
    EXPECT_LT((motion.velocity_at(Vec3::Zero()) - velocity).norm(), 1e-10);
    EXPECT_NEAR(motion.mass, masses.sum(), 1e-14);
  }
}

}  // namespace
}  // namespace griffith
