// Resistance to compaction: what is pressed flat resists ever more, and what is not keeps its bits.

#include "sim/elasticity/compaction.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "sim/core/dense_algebra.h"
#include "sim/elasticity/stiffness.h"
#include "tests/elasticity/random_element.h"

namespace griffith {
namespace {

using testing::elastic_forces;
using testing::elastic_state;
using testing::random_corners;
using testing::RandomValues;

class CompactedElement : public ::testing::TestWithParam<ElementModel> {
 protected:
  ElasticLaw law() const { return {GetParam(), 2e6, 3e6, compaction_modulus(2e6, 3e6)}; }
  ElasticLaw plain() const { return {GetParam(), 2e6, 3e6}; }
  /// Returns the state when pressed to this share of its length along x.
  ElementState pressed_to(const ElasticLaw& law, double share) const {
    RandomValues random(1);
    const Corners corners = random_corners(random);
    return elastic_state(law, rest_element(corners), Vec3(share, 1, 1).asDiagonal() * corners);
  }
  /// Returns its force per area at rest [Pa].
  double pressure_at(const ElasticLaw& law, double share) const {
    const ElementState state = pressed_to(law, share);
    return -(state.frame * state.stress.full())(0, 0);
  }
};
INSTANTIATE_TEST_SUITE_P(Models, CompactedElement,
                         ::testing::Values(ElementModel::corotational, ElementModel::green_strain));

TEST_P(CompactedElement, ForceIsMinusTheGradientOfTheEnergyDownToNoVolumeAndBeyond) {
  RandomValues random(2);
  for (const double share : {0.5, 0.25, 0.1, 0.02, 0.002, -0.1}) {
    const Corners rest_corners = random_corners(random);
    const RestElement rest = rest_element(rest_corners);
    const Mat3 squeeze = random.rotation() * Vec3(1.1, 0.9, share).asDiagonal() * random.rotation();
    const Corners corners = squeeze * rest_corners, force = elastic_forces(law(), rest, corners);
    const auto energy = [&](const Corners& x) { return rest.volume * elastic_state(law(), rest, x).energy_density; };
    const double h = 1e-5 * std::abs(share);
    for (int i = 0; i < 12; ++i) {
      Corners plus = corners, minus = corners;
      plus(i) += h;
      minus(i) -= h;
      EXPECT_NEAR(-(energy(plus) - energy(minus)) / (2 * h), force(i), 1e-5 * force.norm()) << "at " << share;
    }
  }
}

// Green's (lambda + 2 mu) (1 − s²) s/2 is largest at 1/√3, the corotational (lambda + 2 mu) (1 − s) ends at s = 0.
TEST_P(CompactedElement, PressureGrowsWithoutLimit) {
  const double modulus = plain().lambda + 2 * plain().mu;
  const bool is_green = GetParam() == ElementModel::green_strain;
  EXPECT_NEAR(pressure_at(plain(), 0.4), modulus * (is_green ? (1 - 0.16) * 0.2 : 0.6), 1e-9 * modulus);
  EXPECT_LT(pressure_at(plain(), 0.01), modulus);
  double last = 0;
  for (double share = 0.99; share > 1e-3; share *= 0.97) {
    const double pressure = pressure_at(law(), share);
    EXPECT_GT(pressure, last) << "at " << share;
    last = pressure;
  }
  EXPECT_GT(last, 1e4 * modulus);
}

TEST_P(CompactedElement, HasTheBitsOfThePlainOneBefore) {
  for (const double share : {0.58, 0.9, 1.0, 1.5}) {
    const ElementState state = pressed_to(law(), share), without = pressed_to(plain(), share);
    EXPECT_EQ(std::memcmp(&state.stress, &without.stress, sizeof state.stress), 0) << "at " << share;
    EXPECT_EQ(state.energy_density, without.energy_density);
    EXPECT_FALSE(state.is_compacted());
  }
  EXPECT_TRUE(pressed_to(law(), 0.2).is_compacted());
}

TEST_P(CompactedElement, StiffnessIsSymmetricPositiveAndGrowsWithPressure) {
  RandomValues random(3);
  double last = 0;
  for (const double share : {0.25, 0.1, 0.05}) {
    const Corners rest_corners = random_corners(random);
    const RestElement rest = rest_element(rest_corners);
    const ElementState state = elastic_state(law(), rest, Vec3(1, share, 1).asDiagonal() * rest_corners);
    Eigen::Matrix<double, 12, 12> stiffness;
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j) stiffness.block<3, 3>(3 * i, 3 * j) = stiffness_row(law(), rest, state, i).block(j);
    EXPECT_LT((stiffness - stiffness.transpose()).norm(), 1e-12 * stiffness.norm());
    const Eigen::VectorXd eigenvalues = symmetric_modes(stiffness).values;
    EXPECT_GT(eigenvalues[0], -1e-12 * stiffness.norm());
    EXPECT_GT(eigenvalues[11], last);
    last = eigenvalues[11];
  }
}

}  // namespace
}  // namespace griffith
