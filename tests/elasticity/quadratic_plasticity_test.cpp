#include <gtest/gtest.h>

#include <cmath>

#include "sim/elasticity/quadratic_element.h"
#include "tests/elasticity/random_element.h"

namespace griffith {
namespace {

using testing::random_corners;
using testing::RandomValues;
using testing::shaken;

CornerTensors random_deviators(RandomValues& random, double size) {
  CornerTensors strains;
  for (Mat3& strain : strains) {
    const Mat3 m = random.matrix(size);
    strain = 0.5 * (m + m.transpose()) - m.trace() / 3 * Mat3::Identity();
  }
  return strains;
}

/// A tet that is deformed anyhow, and has plastic strain.
class YieldingTet : public ::testing::TestWithParam<ElementModel> {
 protected:
  /// `strain`: about the strains of the tet.
  void deform(double strain) {
    const Corners rest_corners = random_corners(random_);
    rest_ = rest_element(rest_corners);
    corners_ = shaken(random_.rotation() * rest_corners, random_, strain);
    for (int i = 0; i < 6; ++i) offsets_.col(i) = random_.vector(strain / 4);
    before_ = random_deviators(random_, strain / 2);
  }
  CornerTensors flowed() const {
    return flow(plastic_, corner_strains(law_.model, rest_, corners_, offsets_), before_);
  }
  QuadraticStates states() const {
    return quadratic_states(law_, rest_, corners_, offsets_, at_corners(flowed()), plastic_);
  }
  /// Returns the energy that loads have to supply: the elastic one and the work at the yield strength [J].
  double potential() const {
    double work = 0;
    const CornerTensors after = flowed();
    for (int i = 0; i < 4; ++i) work += yield_work(plastic_, law_.mu, after[i] - before_[i]) / 4;
    return rest_.volume * (states().mean.energy_density + work);
  }

  RandomValues random_{1};
  ElasticLaw law_{GetParam(), 2e6, 3e6};
  PlasticLaw plastic_{0.01, 10};
  RestElement rest_;
  Corners corners_;
  EdgeVectors offsets_;
  CornerTensors before_;
};
INSTANTIATE_TEST_SUITE_P(Models, YieldingTet,
                         ::testing::Values(ElementModel::corotational, ElementModel::green_strain));

TEST(IntegrationPoints, ReturnTheValuesOfTheCorners) {
  RandomValues random(2);
  const CornerTensors values = random_deviators(random, 1), returned = at_corners(at_integration_points(values));
  for (int v = 0; v < 4; ++v) EXPECT_LT((returned[v] - values[v]).norm(), 1e-14);
}

TEST_P(YieldingTet, IntegrationPointsHoldItsEnergy) {
  for (int trial = 0; trial < 20; ++trial) {
    deform(0.05);
    const CornerStrains strains = corner_strains(law_.model, rest_, corners_, offsets_);
    const QuadraticStates found = quadratic_states(law_, rest_, corners_, offsets_);
    double sum = 0;
    for (const Mat3& strain : at_integration_points(strains.corners))
      sum += (0.5 * law_.lambda * strain.trace() * strain.trace() + law_.mu * strain.squaredNorm()) / 4;
    EXPECT_NEAR(sum, found.mean.energy_density, 1e-12 * sum);
  }
}

TEST_P(YieldingTet, ForceIsMinusTheGradientOfWhatLoadsSupply) {
  for (int trial = 0; trial < 20; ++trial) {
    deform(0.05);
    const QuadraticForces forces = quadratic_forces(rest_, states().state);
    const double h = 1e-6, size = forces.corners.norm() + forces.edges.norm();
    const auto slope = [&](double& coordinate) {
      const double at = coordinate;
      coordinate = at + h;
      const double plus = potential();
      coordinate = at - h;
      const double minus = potential();
      coordinate = at;
      return (plus - minus) / (2 * h);
    };
    for (int i = 0; i < 12; ++i) EXPECT_NEAR(-slope(corners_(i)), forces.corners(i), 1e-5 * size);
    for (int i = 0; i < 18; ++i) EXPECT_NEAR(-slope(offsets_(i)), forces.edges(i), 1e-5 * size);
  }
}

TEST_P(YieldingTet, NoCornerExceedsTheYieldStrength) {
  int beyond = 0;
  for (int trial = 0; trial < 50; ++trial) {
    deform(0.05);
    const auto deviator = [](const Mat3& m) { return Mat3(m - m.trace() / 3 * Mat3::Identity()); };
    const CornerTensors field = at_corners(flowed());
    const CornerStrains strains = corner_strains(law_.model, rest_, corners_, offsets_);
    const QuadraticState state = states().state;
    for (int v = 0; v < 4; ++v) {
      EXPECT_LE(deviator(state.corners[v].stress).norm(), 2 * law_.mu * plastic_.yield_strain * (1 + 1e-9));
      beyond += deviator(strains.corners[v] - field[v]).norm() > 1.2 * plastic_.yield_strain;
    }
  }
  EXPECT_GT(beyond, 10) << "the linear field does exceed it";
}

TEST_P(YieldingTet, WithoutOffsetsItFlowsAsTheLinearOne) {
  for (int trial = 0; trial < 20; ++trial) {
    deform(0.05);
    offsets_.setZero();
    before_ = at_all_corners(before_[0]);
    const Mat3 linear = flow(plastic_, element_deformation(law_.model, rest_, corners_), before_[0]);
    EXPECT_GT((linear - before_[0]).norm(), 0);
    for (const Mat3& strain : flowed()) EXPECT_LT((strain - linear).norm(), 1e-12);
  }
}

}  // namespace
}  // namespace griffith
