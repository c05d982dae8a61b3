#include <gtest/gtest.h>

#include <Eigen/Cholesky>

#include "sim/core/dense_algebra.h"
#include "sim/solver/aggregates.h"
#include "tests/random_values.h"
#include "tests/solver/elastic_box.h"

namespace griffith {
namespace {

using testing::ElasticBox;
using testing::RandomValues;

Eigen::MatrixXd dense(const BlockSparseMatrix& a) {
  Eigen::MatrixXd m = Eigen::MatrixXd::Zero(3 * a.rows(), 3 * a.rows());
  for (int row = 0; row < a.rows(); ++row)
    for (int k = a.row_starts[row]; k < a.row_starts[row + 1]; ++k)
      m.block<3, 3>(3 * row, 3 * a.columns[k]) = a.blocks[k];
  return m;
}

NodeVectors random_vectors(RandomValues& random, int count) {
  NodeVectors v(3, count);
  for (int i = 0; i < count; ++i) v.col(i) = random.vector();
  return v;
}

TEST(SystemMatrix, IsSymmetricPositiveDefinite) {
  ElasticBox body(Vec3(1, 1, 1), 0.5, 1e9);
  ElasticSystem system = body.system();
  body.assemble(system, {.dt = 0.01, .stiffness_damping = 1e-3});
  const Eigen::MatrixXd a = dense(system.matrix());
  EXPECT_LT((a - a.transpose()).norm(), 1e-12 * a.norm());
  EXPECT_GT(symmetric_modes(a).values[0], 0);
}

TEST(SystemMatrix, StiffnessIgnoresRigidMotion) {
  ElasticBox body(Vec3(1, 2, 1), 0.5, 1e9);
  ElasticSystem system = body.system();
  const double dt = 0.01;
  body.assemble(system, {.dt = dt});
  NodeVectors rigid(3, system.nodes().size()), product;
  for (Eigen::Index i = 0; i < rigid.cols(); ++i)
    rigid.col(i) = Vec3(1, 2, 3) + Vec3(-1, 1, 2).cross(body.positions[system.nodes()[i]]);
  multiply(system.matrix(), rigid, product);
  for (Eigen::Index i = 0; i < rigid.cols(); ++i)
    EXPECT_LT((product.col(i) - body.masses[system.nodes()[i]] * rigid.col(i)).norm(), 1e-12 * dt * dt * 1e9);
}

TEST(Aggregates, CoverEveryRowAndHaveTheWantedSize) {
  ElasticBox body(Vec3(4, 4, 1), 0.25, 1e9);
  ElasticSystem system = body.system();
  const std::vector<int> aggregates = aggregate_rows(system.matrix(), 60);
  std::vector<int> sizes;
  for (int a : aggregates) {
    ASSERT_GE(a, 0);
    if (a >= static_cast<int>(sizes.size())) sizes.resize(a + 1);
    ++sizes[a];
  }
  for (int size : sizes) {
    EXPECT_GE(size, 15);
    EXPECT_LE(size, 180);
  }
}

TEST(ConjugateGradient, AgreesWithADenseSolve) {
  RandomValues random(1);
  ElasticBox body(Vec3(2, 1, 1), 0.25, 1e9);
  ElasticSystem system = body.system();
  body.assemble(system, {.dt = 0.01});
  NodeVectors positions(3, system.nodes().size());
  for (Eigen::Index i = 0; i < positions.cols(); ++i) positions.col(i) = body.positions[system.nodes()[i]];
  RigidModePreconditioner preconditioner(system.matrix(), system.matrix().rows(), 60);
  preconditioner.update(system.matrix(), positions);
  const NodeVectors b = random_vectors(random, static_cast<int>(positions.cols()));
  NodeVectors x = NodeVectors::Zero(3, b.cols());
  const SolveReport report =
      conjugate_gradient(system.matrix(), preconditioner, b, x, 1e-12, std::sqrt(dot(b, b)), 500);
  EXPECT_TRUE(report.converged);
  const Eigen::VectorXd exact =
      dense(system.matrix()).llt().solve(Eigen::Map<const Eigen::VectorXd>(b.data(), b.size()));
  EXPECT_LT((Eigen::Map<const Eigen::VectorXd>(x.data(), x.size()) - exact).norm(), 1e-9 * exact.norm());
}

TEST(ConjugateGradient, ReportsThatItWasCutOff) {
  RandomValues random(2);
  ElasticBox body(Vec3(2, 2, 2), 0.25, 70e9);
  ElasticSystem system = body.system();
  for (Vec3& velocity : body.velocities) velocity = random.vector();
  const ImplicitStep step{.dt = 0.01, .relative_residual = 1e-8, .max_iterations = 3};
  body.assemble(system, step);
  const SolveReport report = body.solve(system, step);
  EXPECT_FALSE(report.converged);
  EXPECT_EQ(report.iterations, 3);
  EXPECT_GT(report.relative_residual, 1e-8);
}

TEST(Preconditioner, IsSymmetric) {
  RandomValues random(3);
  ElasticBox body(Vec3(3, 1, 1), 0.25, 1e9);
  ElasticSystem system = body.system();
  body.assemble(system, {.dt = 0.01});
  NodeVectors positions(3, system.nodes().size());
  for (Eigen::Index i = 0; i < positions.cols(); ++i) positions.col(i) = body.positions[system.nodes()[i]];
  RigidModePreconditioner preconditioner(system.matrix(), system.matrix().rows(), 60);
  preconditioner.update(system.matrix(), positions);
  EXPECT_GT(preconditioner.aggregate_count(), 2);
  for (int i = 0; i < 20; ++i) {
    const NodeVectors u = random_vectors(random, static_cast<int>(positions.cols()));
    const NodeVectors v = random_vectors(random, static_cast<int>(positions.cols()));
    NodeVectors mu, mv;
    const double u_mu = preconditioner.apply(u, mu), v_mv = preconditioner.apply(v, mv);
    EXPECT_EQ(u_mu, dot(u, mu));
    EXPECT_EQ(v_mv, dot(v, mv));
    EXPECT_NEAR(dot(u, mv), dot(v, mu), 1e-6 * std::abs(dot(u, mu)));
    EXPECT_GT(dot(u, mu), 0);
  }
}

TEST(Preconditioner, IsBlockJacobiWhereTheCoarseMatrixCannotBeFactored) {
  RandomValues random(4);
  ElasticBox body(Vec3(3, 1, 1), 0.25, 1e9);
  ElasticSystem system = body.system();
  const auto assemble = [&](double mass) {
    system.assemble(MatrixFactors{mass, 1e-4}, body.law(), body.rest_elements, body.states, body.positions,
                    body.masses);
    return system.gather(body.positions);
  };
  const NodeVectors positions = assemble(1);
  RigidModePreconditioner preconditioner(system.matrix(), system.matrix().rows(), 20);
  preconditioner.update(system.matrix(), positions);
  const NodeVectors r = random_vectors(random, static_cast<int>(positions.cols()));
  NodeVectors sound, z, again;
  preconditioner.apply(r, sound);

  assemble(-1);  // rigid modes have negative energy
  preconditioner.update(system.matrix(), positions);
  preconditioner.apply(r, z);
  for (int row = 0; row < system.matrix().rows(); ++row)
    EXPECT_TRUE(z.col(row).isApprox(system.matrix().blocks[system.matrix().slot(row, row)].inverse() * r.col(row)));
  EXPECT_FALSE(preconditioner.has_coarse_space());

  assemble(1);
  preconditioner.update(system.matrix(), positions);
  preconditioner.apply(r, again);
  EXPECT_EQ(again, sound);
}

TEST(Preconditioner, ReusesItsFactorsAtNoCostWhereLittleMoves) {
  for (double young_modulus : {1e8, 3e10}) {
    RandomValues random(5);
    ElasticBox body(Vec3(2, 2, 0.5), 0.125, young_modulus);
    const ImplicitStep step{.dt = 1.0 / 120};
    ElasticSystem system = body.system();
    body.assemble(system, step);
    NodeVectors positions = system.gather(body.positions);
    RigidModePreconditioner kept(system.matrix(), system.matrix().rows(), 20),
        renewed(system.matrix(), system.matrix().rows(), 20);
    kept.update(system.matrix(), positions);
    // Turned a little and strained more than brittle bodies bear.
    const Mat3 turn = Eigen::AngleAxisd(2e-4, random.direction()).toRotationMatrix();
    for (Vec3& position : body.positions) position = turn * position + random.vector(2e-5);
    body.update_states();
    body.assemble(system, step);
    positions = system.gather(body.positions);
    kept.update(system.matrix(), positions);
    EXPECT_EQ(kept.factorization_count(), 1);
    EXPECT_EQ(kept.assembly_count(), 1);
    renewed.update(system.matrix(), positions);
    const NodeVectors b = random_vectors(random, static_cast<int>(positions.cols()));
    NodeVectors x = NodeVectors::Zero(3, b.cols()), y = x;
    const double scale = std::sqrt(dot(b, b));
    const int iterations = conjugate_gradient(system.matrix(), kept, b, x, 1e-6, scale, 500).iterations;
    EXPECT_LE(iterations, conjugate_gradient(system.matrix(), renewed, b, y, 1e-6, scale, 500).iterations + 2);
    // A quarter turn is no little motion.
    for (Vec3& position : body.positions) position = Vec3(-position.y(), position.x(), position.z());
    body.update_states();
    body.assemble(system, step);
    kept.update(system.matrix(), system.gather(body.positions));
    EXPECT_EQ(kept.factorization_count(), 2);
    EXPECT_EQ(kept.assembly_count(), 2);
    // Stiff bodies hide their masses in the matrix, but rigid motions are made of nothing else.
    for (double& mass : body.masses) mass *= 2;
    body.assemble(system, step);
    kept.update(system.matrix(), system.gather(body.positions));
    EXPECT_EQ(kept.assembly_count(), 3);
  }
}

TEST(Preconditioner, KeepsTheIterationsIndependentOfTheStiffness) {
  for (double young_modulus : {1e6, 1e8, 1e10, 4e11}) {
    RandomValues random(4);
    ElasticBox body(Vec3(2, 2, 0.5), 0.125, young_modulus);
    ElasticSystem system = body.system();
    for (Vec3& velocity : body.velocities) velocity = random.vector();
    const ImplicitStep step{.dt = 1.0 / 120, .relative_residual = 1e-3};
    body.assemble(system, step);
    const SolveReport report = body.solve(system, step);
    EXPECT_TRUE(report.converged);
    EXPECT_LE(report.iterations, 40) << "E = " << young_modulus;
  }
}

}  // namespace
}  // namespace griffith
