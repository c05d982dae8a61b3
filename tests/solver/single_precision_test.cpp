#include "sim/solver/single_precision.h"

#include <gtest/gtest.h>

#include "sim/core/parallel.h"
#include "tests/random_values.h"
#include "tests/solver/elastic_box.h"

namespace griffith {
namespace {

using testing::ElasticBox;
using testing::RandomValues;

/// A matrix that is large enough for single precision, its preconditioner, and a right-hand side.
struct LargeProblem {
  ElasticBox body;
  ElasticSystem system;
  RigidModePreconditioner preconditioner;
  NodeVectors b;

  LargeProblem(const Vec3& size, double element_size, double young_modulus)
      : body(size, element_size, young_modulus),
        system(assembled(body)),
        preconditioner(system.matrix(), system.matrix().rows(), 20) {
    NodeVectors positions = system.gather(body.positions);
    preconditioner.update(system.matrix(), positions);
    RandomValues random(7);
    b.resize(3, system.matrix().rows());
    for (Eigen::Index i = 0; i < b.cols(); ++i) b.col(i) = random.vector();
  }
  static ElasticSystem assembled(ElasticBox& body) {
    ElasticSystem system = body.system();
    body.assemble(system, {.dt = 1.0 / 120});
    return system;
  }
  double residual(const NodeVectors& x) const {
    NodeVectors product;
    multiply(system.matrix(), x, product);
    return (b - product).norm();
  }
  NodeVectors solve(double tolerance, SolveReport& report) const {
    NodeVectors x = NodeVectors::Zero(3, b.cols());
    report = conjugate_gradient(system.matrix(), preconditioner, b, x, tolerance, b.norm(), 2000);
    return x;
  }
};

LargeProblem block() { return {Vec3(2, 2, 1), 0.1, 3e10}; }

TEST(SinglePrecision, ThePreconditionerIsTheSame) {
  const LargeProblem problem = block();
  ASSERT_GT(problem.system.matrix().rows(), 4096);
  NodeVectors expected;
  problem.preconditioner.apply(problem.b, expected);
  SingleVectors r, z(problem.b.cols());
  for (Eigen::Index i = 0; i < problem.b.cols(); ++i) {
    const Eigen::Vector3f v = problem.b.col(i).cast<float>();
    r.push_back(simd::Quad{v[0], v[1], v[2], 0});
  }
  const double product = SinglePrecisionPreconditioner(problem.preconditioner).apply(r, z);
  double error = 0;
  for (Eigen::Index i = 0; i < expected.cols(); ++i) {
    error += (Vec3(z[i][0], z[i][1], z[i][2]) - expected.col(i)).squaredNorm();
    EXPECT_EQ(z[i][3], 0);
  }
  EXPECT_LT(std::sqrt(error), 1e-5 * expected.norm());
  EXPECT_NEAR(product, dot(problem.b, expected), 1e-5 * product);
}

TEST(SinglePrecision, GetsMostOfTheWayByItself) {
  const LargeProblem problem = block();
  NodeVectors d;
  const int iterations = solve_in_single_precision(problem.system.matrix(), problem.preconditioner, problem.b,
                                                   1e-3 * problem.b.norm(), 2000, {}, d);
  EXPECT_GT(iterations, 5);
  EXPECT_LT(iterations, 200);
  EXPECT_LT(problem.residual(d), 0.05 * problem.b.norm());
}

TEST(SinglePrecision, TheAskedResidualIsReachedInDoublePrecision) {
  // A rod whose softest motion is a hundred million times softer than its elements.
  for (const LargeProblem& problem : {block(), LargeProblem(Vec3(100, 0.2, 0.2), 0.1, 3e11)}) {
    ASSERT_GT(problem.system.matrix().rows(), 4096);
    SolveReport exact_report;
    const NodeVectors exact = problem.solve(1e-9, exact_report);
    ASSERT_TRUE(exact_report.converged);
    double error = 0;
    for (const double tolerance : {1e-2, 1e-3, 1e-5}) {
      SolveReport report;
      const NodeVectors x = problem.solve(tolerance, report);
      EXPECT_TRUE(report.converged) << tolerance;
      EXPECT_LE(problem.residual(x), 1.001 * tolerance * problem.b.norm()) << tolerance;
      EXPECT_NEAR(report.relative_residual, problem.residual(x) / problem.b.norm(), 1e-3 * tolerance) << tolerance;
      error = (x - exact).norm();
    }
    EXPECT_LT(error, 0.1 * exact.norm());
  }
}

TEST(SinglePrecision, EndsWhereItIsToldTo) {
  const LargeProblem problem = block();
  NodeVectors x = NodeVectors::Zero(3, problem.b.cols());
  const SolveReport report =
      conjugate_gradient(problem.system.matrix(), problem.preconditioner, problem.b, x, 1e-5, problem.b.norm(), 3);
  EXPECT_EQ(report.iterations, 3);
  EXPECT_FALSE(report.converged);
  EXPECT_LT(problem.residual(x), problem.b.norm());
}

TEST(SinglePrecision, SolvesToTheSameBitsForAnyNumberOfThreads) {
  const LargeProblem problem = block();
  SolveReport report;
  std::vector<NodeVectors> solutions;
  for (const int threads : {1, 2, 4}) {
    const ThreadLimit limit(threads);
    solutions.push_back(problem.solve(1e-3, report));
  }
  EXPECT_EQ(solutions[0], solutions[1]);
  EXPECT_EQ(solutions[0], solutions[2]);
}

}  // namespace
}  // namespace griffith
