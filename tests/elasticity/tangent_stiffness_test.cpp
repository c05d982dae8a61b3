// Second derivatives of an element's energy: those of its forces, of all laws, and what is raised of them.

#include "sim/elasticity/tangent_stiffness.h"

#include <gtest/gtest.h>

#include "sim/core/dense_algebra.h"
#include "sim/elasticity/compaction.h"
#include "tests/elasticity/random_element.h"

namespace griffith {
namespace {

using testing::elastic_forces;
using testing::random_corners;
using testing::RandomValues;
using ElementMatrix = Eigen::Matrix<double, 12, 12>;

constexpr double kNoBound = -1e30;

ElementMatrix matrix_of(const RestElement& rest, const TangentStiffness& tangent) {
  ElementMatrix matrix;
  for (int i = 0; i < 4; ++i) {
    const StiffnessRow row = tangent.row(rest, i, 1);
    for (int j = 0; j < 4; ++j) matrix.block<3, 3>(3 * i, 3 * j) = row.block(j);
  }
  return matrix;
}

class Tangent : public ::testing::TestWithParam<ElementModel> {
 protected:
  ElasticLaw law() const { return {GetParam(), 2e6, 3e6, compaction_modulus(2e6, 3e6)}; }
};
INSTANTIATE_TEST_SUITE_P(Models, Tangent, ::testing::Values(ElementModel::corotational, ElementModel::green_strain));

TEST_P(Tangent, IsMinusTheGradientOfTheForces) {
  RandomValues random(3);
  for (const double share : {1.4, 1.0, 0.7, 0.45, 0.2, 0.05, -0.1}) {
    const Corners rest_corners = random_corners(random);
    const RestElement rest = rest_element(rest_corners);
    const Mat3 strain = random.rotation() * Vec3(1.1, 0.8, share).asDiagonal() * random.rotation();
    const Corners corners = strain * rest_corners;
    const ElementMatrix matrix = matrix_of(rest, tangent_stiffness(law(), rest, corners, kNoBound));
    const double h = 1e-6 * std::abs(share);
    for (int i = 0; i < 12; ++i) {
      Corners plus = corners, minus = corners;
      plus(i) += h;
      minus(i) -= h;
      const Corners slope = (elastic_forces(law(), rest, minus) - elastic_forces(law(), rest, plus)) / (2 * h);
      EXPECT_NEAR((slope.reshaped() - matrix.col(i)).norm(), 0, 1e-5 * matrix.norm()) << "at " << share << ", " << i;
    }
  }
}

TEST_P(Tangent, HasNoEigenvalueBelowTheBound) {
  RandomValues random(4);
  for (int i = 0; i < 100; ++i) {
    const Corners rest_corners = random_corners(random);
    const RestElement rest = rest_element(rest_corners);
    const Corners corners = testing::shaken(rest_corners, random, 1);
    const auto least_of = [&](double least) {
      return symmetric_modes(matrix_of(rest, tangent_stiffness(law(), rest, corners, least))).values[0];
    };
    const double rounding = 1e-9 * law().mu * rest.volume * rest.shape_gradients.squaredNorm();
    EXPECT_GE(least_of(0), -1e3 * rounding);
    EXPECT_GE(least_of(-1e5), -1e5 * rest.volume * rest.shape_gradients.squaredNorm() - 1e3 * rounding);
  }
}

}  // namespace
}  // namespace griffith
