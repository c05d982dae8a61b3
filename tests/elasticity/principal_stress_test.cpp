#include "sim/elasticity/principal_stress.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>

#include "tests/random_values.h"

namespace griffith {
namespace {

using testing::RandomValues;

/// By Eigen's iterative solver, the accurate one.
Mat3 reference(const Mat3& stress) {
  const Eigen::SelfAdjointEigenSolver<Mat3> solver(stress);
  return solver.eigenvectors() * solver.eigenvalues().cwiseMax(0).asDiagonal() * solver.eigenvectors().transpose();
}

Mat3 symmetric(const Mat3& axes, const Vec3& values) {
  const Mat3 m = axes * values.asDiagonal() * axes.transpose();
  return 0.5 * (m + m.transpose());
}

TEST(VonMises, OfUniaxialStressIsThatStress) {
  RandomValues random(11);
  for (int i = 0; i < 100; ++i) {
    const double stress = random.uniform(-5e6, 5e6);
    EXPECT_NEAR(von_mises_stress(symmetric(random.rotation(), Vec3(stress, 0, 0))), std::abs(stress), 1e-6);
  }
}

TEST(VonMises, OfShearIsItsRootOfThreeAndOfPressureNothing) {
  Mat3 shear = Mat3::Zero();
  shear(0, 1) = shear(1, 0) = 1e6;
  EXPECT_NEAR(von_mises_stress(shear), std::sqrt(3.0) * 1e6, 1e-6);
  EXPECT_NEAR(von_mises_stress(-5e6 * Mat3::Identity()), 0, 1e-6);
}

TEST(PrincipalStresses, AreOrderedAndDoNotTurn) {
  RandomValues random(12);
  for (int i = 0; i < 500; ++i) {
    const Vec3 values = 1e6 * random.vector();
    const Mat3 stress = symmetric(random.rotation(), values);
    const Vec3 principal = principal_stresses(stress);
    EXPECT_GE(principal[0], principal[1]);
    EXPECT_GE(principal[1], principal[2]);
    EXPECT_NEAR(principal[0], values.maxCoeff(), 1e-6);
    EXPECT_NEAR(principal[2], values.minCoeff(), 1e-6);
    EXPECT_NEAR(principal.sum(), stress.trace(), 1e-6);
  }
}

TEST(PrincipalStresses, OfWhatIsNotFiniteAreNoNumbers) {
  Mat3 stress = Mat3::Identity();
  stress(1, 2) = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(principal_stresses(stress).array().isNaN().all());
}

TEST(TensilePart, KeepsTensionDropsCompression) {
  RandomValues random(1);
  for (int i = 0; i < 5000; ++i) {
    const Mat3 m = random.matrix(1e6), stress = m + m.transpose(), tensile = tensile_part(stress);
    const Mat3 compressive = stress - tensile;
    EXPECT_GT(principal_values(tensile).values[0], -1);
    EXPECT_LT(principal_values(compressive).values[2], 1);
    EXPECT_LT((tensile * compressive).norm(), 1e-9 * stress.squaredNorm());
  }
}

TEST(TensilePart, AgreesWithTheEigenvaluesOfAnySigns) {
  RandomValues random(2);
  for (int i = 0; i < 20000; ++i) {
    const Vec3 values = std::pow(10, random.uniform(-20, 12)) * random.vector();
    const Mat3 stress = symmetric(random.rotation(), values);
    EXPECT_LT((tensile_part(stress) - reference(stress)).norm(), 1e-13 * stress.norm()) << values.transpose();
  }
}

TEST(TensilePart, StaysAccurateForDoubleTinyAndVanishingValues) {
  RandomValues random(3);
  for (double tiny : {0.0, 1e-16, 1e-12, 1e-9, 1e-8, 1e-7, 1e-5, 1e-3})
    for (const Vec3& values : {Vec3(1, 1, -1), Vec3(1, -1, -1), Vec3(1, 0, 0), Vec3(-1, 0, 0), Vec3(1, 1, 0),
                               Vec3(1, 1, 1), Vec3(-1, -1, -1), Vec3(1, -1, 0), Vec3(-1, -1, 0)})
      for (int i = 0; i < 50; ++i) {
        const Mat3 stress = 1e8 * symmetric(random.rotation(), values + random.vector(tiny));
        EXPECT_LT((tensile_part(stress) - reference(stress)).norm(), 1e-13 * stress.norm())
            << values.transpose() << ", " << tiny;
      }
}

TEST(TensilePart, OfNothingIsNothing) { EXPECT_EQ(tensile_part(Mat3::Zero()), Mat3::Zero()); }

TEST(TensilePart, OfDiagonalStressesIsExact) {
  const Mat3 stress = Vec3(2, -3, 5).asDiagonal();
  EXPECT_LT((tensile_part(stress) - Mat3(Vec3(2, 0, 5).asDiagonal())).norm(), 1e-14);
  EXPECT_LT((tensile_part(-stress) - Mat3(Vec3(0, 3, 0).asDiagonal())).norm(), 1e-14);
}

bool same_number(double a, double b) { return std::memcmp(&a, &b, sizeof a) == 0 || (std::isnan(a) && std::isnan(b)); }

bool are_same(const LargestPrincipal& a, const LargestPrincipal& b) {
  return same_number(a.value, b.value) &&
         std::equal(a.direction.begin(), a.direction.end(), b.direction.begin(), b.direction.end(), same_number);
}

/// Matrices of all kinds: any, zero, isotropic, of one value (pulled or pushed), across an axis, enormous, tiny and
/// without numbers.
Mat3 some_matrix(RandomValues& random, int kind) {
  const Vec3 v = random.vector();
  Mat3 broken = Mat3::Identity();
  broken(1, 2) = broken(2, 1) = kind % 2 == 0 ? std::numeric_limits<double>::quiet_NaN() : INFINITY;
  const Mat3 any = symmetric(random.rotation(), v);
  switch (kind % 9) {
    case 0:
      return any;
    case 1:
      return Mat3::Zero();
    case 2:
      return v.x() * Mat3::Identity();
    case 3:
      return v * v.transpose();
    case 4:
      return -v * v.transpose();
    case 5:
      return Vec3(v.x(), v.y(), 0).asDiagonal();
    case 6:
      return 1e150 * any;
    case 7:
      return 1e-160 * any;
    default:
      return broken;
  }
}

TEST(LargestPrincipal, ByItsValueAloneIsTheLargestOfTheEigenvalues) {
  RandomValues random(22);
  for (const Vec3& values :
       {Vec3(3, 1, -2), Vec3(2, -1, -3), Vec3(1, 1, -1), Vec3(1, -1, -1), Vec3(1, 0, 0), Vec3(-1, 0, 0), Vec3(1, 1, 0),
        Vec3(-1, -1, 0), Vec3(1, 1, 1), Vec3(-1, -1, -1), Vec3(0, 0, 0), Vec3(1, -1, 0)})
    for (const double change : {0.0, 1e-12, 1e-8, 1e-4, 1.0})
      for (int i = 0; i < 50; ++i) {
        std::array<Mat3, 4> four;
        for (Mat3& m : four) m = 1e7 * symmetric(random.rotation(), values + random.vector(change));
        const std::array<double, 4> found = largest_principal_values(four);
        for (std::size_t lane = 0; lane < 4; ++lane)
          EXPECT_NEAR(found[lane], principal_stresses(four[lane])[0], 2e-8 * four[lane].norm()) << four[lane];
      }
}

TEST(LargestPrincipal, OfFourSideBySideHasTheBitsOfOneAtATime) {
  RandomValues random(21);
  for (int trial = 0; trial < 2000; ++trial) {
    std::array<Mat3, 4> four;
    for (int lane = 0; lane < 4; ++lane) four[lane] = some_matrix(random, random.index(90));
    const std::array<LargestPrincipal, 4> found = largest_principals(four);
    for (int lane = 0; lane < 4; ++lane)
      ASSERT_TRUE(are_same(found[lane], largest_principal(four[lane]))) << lane << ":\n" << four[lane];
  }
}

}  // namespace
}  // namespace griffith
