#include "sim/elasticity/polar_decomposition.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>

#include "tests/random_values.h"

namespace griffith {
namespace {

using testing::RandomValues;

void expect_rotation(const Mat3& q) {
  EXPECT_LT((q.transpose() * q - Mat3::Identity()).norm(), 1e-12);
  EXPECT_NEAR(q.determinant(), 1, 1e-12);
}

TEST(PolarDecomposition, RecoversRotationOfAStretchedRotation) {
  RandomValues random(1);
  for (int i = 0; i < 1000; ++i) {
    const Mat3 rotation = random.rotation(), axes = random.rotation();
    const Vec3 stretches(random.uniform(0.2, 3), random.uniform(0.2, 3), random.uniform(0.2, 3));
    const Mat3 stretch = axes * stretches.asDiagonal() * axes.transpose();
    EXPECT_LT((polar_rotation(rotation * stretch) - rotation).norm(), 1e-12);
  }
}

TEST(PolarDecomposition, IsARotationWithSymmetricStretchForAnyMatrix) {
  RandomValues random(2);
  for (int i = 0; i < 1000; ++i) {
    const Mat3 f = random.matrix(std::pow(10, random.uniform(-8, 8)));
    const Mat3 q = polar_rotation(f);
    expect_rotation(q);
    const Mat3 stretch = q.transpose() * f;
    EXPECT_LT((stretch - stretch.transpose()).norm(), 1e-9 * f.norm());
  }
}

TEST(PolarDecomposition, SurvivesSingularMatrices) {
  RandomValues random(3);
  expect_rotation(polar_rotation(Mat3::Zero()));
  for (int i = 0; i < 100; ++i) {
    const Vec3 a = random.vector(), b = random.vector();
    expect_rotation(polar_rotation(a * b.transpose()));
    Mat3 flat = random.matrix();
    flat.col(2) = flat.col(0) - flat.col(1);
    expect_rotation(polar_rotation(flat));
  }
}

TEST(PolarDecomposition, UnfoldsAnInvertedMatrixAlongItsSmallestStretch) {
  RandomValues random(4);
  for (int i = 0; i < 100; ++i) {
    const Mat3 rotation = random.rotation();
    const Vec3 stretches(2, 1.5, -0.5);
    EXPECT_LT((polar_rotation(rotation * Mat3(stretches.asDiagonal())) - rotation).norm(), 1e-10);
  }
}

}  // namespace
}  // namespace griffith
