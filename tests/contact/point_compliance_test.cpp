#include "sim/core/point_compliance.h"

#include <gtest/gtest.h>

#include <random>

namespace griffith {
namespace {

/// Random points on a few nodes, with modes that count and modes that count against.
PointCompliance random_compliance(int seed, int points, int modes, bool with_offsets) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  const auto matrix = [&] { return Mat3(Mat3::NullaryExpr([&] { return normal(random); })); };
  std::vector<WeightedRows> rows(points);
  for (WeightedRows& row : rows) {
    for (int k = 0; k < 3; ++k) row.rows[k] = static_cast<int>(random() % 12) - 1;
    for (Mat3& weight : row.weights) weight = matrix();
  }
  std::vector<Mat3> nodes;
  for (int i = 0; i < 11; ++i) nodes.push_back(matrix() * Mat3::Identity() + 2 * Mat3::Identity());
  for (Mat3& node : nodes) node = (node * node.transpose()).eval();
  PointCompliance compliance = node_compliance(rows, nodes);
  compliance.modes = Eigen::MatrixXd::NullaryExpr(modes, 3 * points, [&] { return normal(random); });
  if (with_offsets)
    for (bool removed : {false, true}) {
      std::vector<Mat3> blocks(points);
      for (Mat3& block : blocks) block = matrix();
      compliance.add_modes(nodes[0], blocks, removed);
    }
  return compliance;
}

/// C, entry by entry from its definition.
Eigen::MatrixXd defined(const PointCompliance& compliance) {
  Eigen::VectorXd signs = Eigen::VectorXd::Ones(compliance.modes.rows());
  signs.tail(compliance.removed_modes).setConstant(-1);
  Eigen::MatrixXd sum = compliance.modes.transpose() * signs.asDiagonal() * compliance.modes;
  const auto count = static_cast<Eigen::Index>(compliance.points.size());
  for (std::size_t node = 0; node < compliance.nodes.size(); ++node) {
    Eigen::MatrixXd weights = Eigen::MatrixXd::Zero(3 * count, 3);
    for (Eigen::Index i = 0; i < count; ++i)
      for (int k = 0; k < 3; ++k)
        if (compliance.points[i].rows[k] == static_cast<int>(node))
          weights.block<3, 3>(3 * i, 0) += compliance.points[i].weights[k];
    sum += weights * compliance.nodes[node] * weights.transpose();
  }
  return sum;
}

TEST(PointCompliance, AnswersAsItsMatrixDoes) {
  for (int seed = 0; seed < 10; ++seed) {
    const PointCompliance compliance = random_compliance(seed, 9, 5, seed % 2 == 0);
    const Eigen::MatrixXd whole = defined(compliance);
    EXPECT_LT((whole - whole.transpose()).norm(), 1e-12 * whole.norm());
    std::mt19937 random(seed);
    std::normal_distribution<double> normal;
    const Eigen::Matrix3Xd impulses = Eigen::Matrix3Xd::NullaryExpr(3, 9, [&] { return normal(random); });
    const Eigen::VectorXd expected = whole * impulses.reshaped();
    EXPECT_LT((respond(compliance, impulses).reshaped() - expected).norm(), 1e-12 * expected.norm());
    for (int i = 0; i < 9; ++i)
      EXPECT_LT((compliance.block(i) - whole.block<3, 3>(3 * i, 3 * i)).norm(), 1e-12 * whole.norm());
  }
}

TEST(PointCompliance, ImpulsesOneAfterTheOtherAddUp) {
  const PointCompliance compliance = random_compliance(3, 7, 4, true);
  std::mt19937 random(5);
  std::normal_distribution<double> normal;
  Eigen::Matrix3Xd sum = Eigen::Matrix3Xd::Zero(3, 7);
  const Eigen::Matrix3Xd start = Eigen::Matrix3Xd::NullaryExpr(3, 7, [&] { return normal(random); });
  PointMotion motion(compliance, start);
  for (int i = 0; i < 50; ++i) {
    const int point = static_cast<int>(random() % 7);
    const Vec3 impulse(normal(random), normal(random), normal(random));
    motion.push(point, impulse);
    sum.col(point) += impulse;
    const Eigen::Matrix3Xd expected = start + respond(compliance, sum);
    for (int k = 0; k < 7; ++k) EXPECT_LT((motion.velocity(k) - expected.col(k)).norm(), 1e-11 * expected.norm());
  }
}

TEST(PointCompliance, ScalesAsAWhole) {
  PointCompliance compliance = random_compliance(8, 5, 3, true);
  const Eigen::MatrixXd before = defined(compliance);
  compliance.scale(2.5);
  EXPECT_LT((defined(compliance) - 2.5 * before).norm(), 1e-12 * before.norm());
}

}  // namespace
}  // namespace griffith
