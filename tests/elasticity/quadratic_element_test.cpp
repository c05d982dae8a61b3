#include "sim/elasticity/quadratic_element.h"

#include <gtest/gtest.h>

#include "sim/core/dense_algebra.h"
#include "sim/core/tet_edge_corners.h"
#include "sim/elasticity/quadratic_batch.h"
#include "sim/elasticity/quadratic_stiffness.h"
#include "tests/elasticity/random_element.h"

namespace griffith {
namespace {

using testing::elastic_forces;
using testing::elastic_state;
using testing::random_corners;
using testing::RandomValues;
using testing::shaken;

/// Corners, then edges.
using Degrees = Eigen::Matrix<double, 3, 10>;
using Stiffness = Eigen::Matrix<double, 30, 30>;

EdgeVectors random_offsets(RandomValues& random, double size) {
  EdgeVectors offsets;
  for (int i = 0; i < 6; ++i) offsets.col(i) = random.vector(size);
  return offsets;
}

QuadraticStates states_at(const ElasticLaw& law, const RestElement& rest, const Degrees& x) {
  return quadratic_states(law, rest, x.leftCols<4>(), x.rightCols<6>());
}

double energy_at(const ElasticLaw& law, const RestElement& rest, const Degrees& x) {
  return rest.volume * states_at(law, rest, x).mean.energy_density;
}

Degrees forces_at(const ElasticLaw& law, const RestElement& rest, const Degrees& x) {
  const QuadraticForces forces = quadratic_forces(rest, states_at(law, rest, x).state);
  Degrees all;
  all << forces.corners, forces.edges;
  return all;
}

Stiffness stiffness_at(const ElasticLaw& law, const RestElement& rest, const Degrees& x) {
  const ElementState mean = states_at(law, rest, x).mean;
  Stiffness stiffness;
  for (int i = 0; i < 10; ++i)
    for (int j = 0; j < 10; ++j)
      stiffness.block<3, 3>(3 * i, 3 * j) = quadratic_stiffness_row(law, rest, mean, i).block(j);
  return stiffness;
}

class QuadraticElement : public ::testing::TestWithParam<ElementModel> {
 protected:
  /// A tet turned anyhow, its corners and edges shaken.
  Degrees random_degrees(const Corners& rest_corners, double size) {
    Degrees x;
    x << shaken(random_.rotation() * rest_corners, random_, size), random_offsets(random_, size);
    return x;
  }

  RandomValues random_{1};
  ElasticLaw law_{GetParam(), 2e6, 3e6};
};
INSTANTIATE_TEST_SUITE_P(Models, QuadraticElement,
                         ::testing::Values(ElementModel::corotational, ElementModel::green_strain));

TEST_P(QuadraticElement, ForceIsMinusTheGradientOfTheEnergy) {
  for (int trial = 0; trial < 50; ++trial) {
    const Corners rest_corners = random_corners(random_);
    const RestElement rest = rest_element(rest_corners);
    const Degrees x = random_degrees(rest_corners, 0.05), force = forces_at(law_, rest, x);
    const double h = 1e-5;
    for (int i = 0; i < 30; ++i) {
      Degrees plus = x, minus = x;
      plus(i) += h;
      minus(i) -= h;
      EXPECT_NEAR(-(energy_at(law_, rest, plus) - energy_at(law_, rest, minus)) / (2 * h), force(i),
                  1e-6 * force.norm());
    }
  }
}

TEST_P(QuadraticElement, ForcesHaveNoResultantAndNoTorque) {
  for (int trial = 0; trial < 50; ++trial) {
    const Corners rest_corners = random_corners(random_);
    const RestElement rest = rest_element(rest_corners);
    const Degrees x = random_degrees(rest_corners, 0.1), force = forces_at(law_, rest, x);
    Vec3 torque = Vec3::Zero();
    for (int i = 0; i < 10; ++i) torque += x.col(i).cross(force.col(i));
    EXPECT_LT(force.leftCols<4>().rowwise().sum().norm(), 1e-12 * force.norm());
    EXPECT_LT(torque.norm(), 1e-12 * force.norm());
  }
}

/// Four at a time, one of them inverted.
TEST_P(QuadraticElement, StressesOfFourHaveTheBitsOfOne) {
  for (int trial = 0; trial < 20; ++trial) {
    std::array<PlacedQuadratic, 4> placed;
    std::array<RestElement, 4> rests;
    for (int i = 0; i < 4; ++i) {
      const Corners rest_corners = random_corners(random_);
      rests[i] = rest_element(rest_corners);
      Degrees x = random_degrees(rest_corners, 0.1);
      if (i == trial % 5) x.row(0) *= -1;
      const Mat3 free = random_.matrix(1e-3);
      placed[i] = {&rests[i], x.leftCols<4>(), x.rightCols<6>(), at_all_corners(free + free.transpose())};
    }
    const std::array<QuadraticStates, 4> four = quadratic_stresses(law_, placed);
    for (int i = 0; i < 4; ++i) {
      const QuadraticStates one =
          quadratic_states(law_, rests[i], placed[i].corners, placed[i].offsets, placed[i].stress_free);
      EXPECT_EQ(four[i].mean.frame, one.mean.frame);
      EXPECT_EQ(four[i].mean.stress.full(), one.mean.stress.full());
      EXPECT_EQ(four[i].mean.tension.full(), one.mean.tension.full());
      EXPECT_EQ(four[i].mean.energy_density, one.mean.energy_density);
      EXPECT_EQ(four[i].mean_cauchy_stress, one.mean_cauchy_stress);
      for (int v = 0; v < 4; ++v) {
        EXPECT_EQ(four[i].state.corners[v].stress.full(), one.state.corners[v].stress.full());
        EXPECT_EQ(four[i].state.corners[v].tensile_traction, one.state.corners[v].tensile_traction);
      }
    }
  }
}

TEST_P(QuadraticElement, WithoutOffsetsItIsTheLinearOne) {
  for (int trial = 0; trial < 50; ++trial) {
    const Corners rest_corners = random_corners(random_);
    const RestElement rest = rest_element(rest_corners);
    Degrees x = random_degrees(rest_corners, 0.1);
    x.rightCols<6>().setZero();
    const ElementState linear = elastic_state(law_, rest, x.leftCols<4>());
    const QuadraticStates quadratic = states_at(law_, rest, x);
    const double size = linear.stress.full().norm();
    for (const ElementState& corner : quadratic.state.corners)
      EXPECT_LT((corner.stress.full() - linear.stress.full()).norm(), 1e-12 * size);
    EXPECT_LT((quadratic.mean.stress.full() - linear.stress.full()).norm(), 1e-12 * size);
    EXPECT_NEAR(quadratic.mean.energy_density, linear.energy_density, 1e-12 * linear.energy_density);
    const Corners forces = elastic_forces(law_, rest, x.leftCols<4>());
    EXPECT_LT((forces_at(law_, rest, x).leftCols<4>() - forces).norm(), 1e-11 * forces.norm());
  }
}

TEST_P(QuadraticElement, TurnsWithItsPlacesAndOffsets) {
  for (int trial = 0; trial < 50; ++trial) {
    const Corners rest_corners = random_corners(random_);
    const RestElement rest = rest_element(rest_corners);
    const Degrees x = random_degrees(rest_corners, 0.1);
    const Mat3 turn = random_.rotation();
    Degrees turned = turn * x;
    turned.leftCols<4>().colwise() += random_.vector(10);
    const Degrees force = forces_at(law_, rest, x);
    EXPECT_NEAR(energy_at(law_, rest, turned), energy_at(law_, rest, x), 1e-10 * energy_at(law_, rest, x));
    EXPECT_LT((forces_at(law_, rest, turned) - turn * force).norm(), 1e-10 * force.norm());
  }
}

/// Displacements ½ Σ_ab c_ab X_a X_b in each component: strain is linear, and known at the corners.
TEST_P(QuadraticElement, CornersHaveTheStrainOfAQuadraticField) {
  const double size = 1e-7;  // where the models agree
  for (int trial = 0; trial < 20; ++trial) {
    const Corners rest_corners = random_corners(random_);
    const RestElement rest = rest_element(rest_corners);
    std::array<Mat3, 3> curvatures;
    for (Mat3& c : curvatures) c = random_.matrix(), c = (c + c.transpose()).eval();
    const auto field = [&](const Vec3& place) {
      Vec3 u;
      for (int k = 0; k < 3; ++k) u[k] = 0.5 * size * place.dot(curvatures[k] * place);
      return u;
    };
    Degrees x;
    for (int i = 0; i < 4; ++i) x.col(i) = rest_corners.col(i) + field(rest_corners.col(i));
    for (int i = 0; i < 6; ++i) {
      const Vec3 a = rest_corners.col(kTetEdges[i][0]), b = rest_corners.col(kTetEdges[i][1]);
      x.col(4 + i) = field((a + b) / 2) - (field(a) + field(b)) / 2;
    }
    const QuadraticStates states = states_at(law_, rest, x);
    for (int v = 0; v < 4; ++v) {
      Mat3 gradient;
      for (int k = 0; k < 3; ++k) gradient.row(k) = size * (curvatures[k] * rest_corners.col(v)).transpose();
      const Mat3 strain = 0.5 * (gradient + gradient.transpose());
      const Mat3 stress = law_.lambda * strain.trace() * Mat3::Identity() + 2 * law_.mu * strain;
      EXPECT_LT((states.state.corners[v].stress.full() - stress).norm(), 1e-5 * stress.norm() + 1e-2 * size);
    }
  }
}

TEST_P(QuadraticElement, StiffnessIsTheDerivativeOfTheForceAtRest) {
  for (int trial = 0; trial < 20; ++trial) {
    const Corners rest_corners = random_corners(random_);
    const RestElement rest = rest_element(rest_corners);
    Degrees x = random_degrees(rest_corners, 0);
    const Stiffness stiffness = stiffness_at(law_, rest, x);
    const double h = 1e-6;
    Stiffness quotient;
    for (int i = 0; i < 30; ++i) {
      Degrees plus = x, minus = x;
      plus(i) += h;
      minus(i) -= h;
      quotient.col(i) = ((forces_at(law_, rest, minus) - forces_at(law_, rest, plus)) / (2 * h)).reshaped();
    }
    EXPECT_LT((quotient - stiffness).norm(), 1e-6 * stiffness.norm());
  }
}

TEST_P(QuadraticElement, DampingIsTheStiffnessTimesTheVelocities) {
  const Corners rest_corners = random_corners(random_);
  const RestElement rest = rest_element(rest_corners);
  Degrees x = Degrees::Zero(), velocities;
  x.leftCols<4>() = random_.rotation() * rest_corners;
  velocities << random_corners(random_), random_offsets(random_, 1);
  const QuadraticForces found = quadratic_damping_forces(law_, rest, states_at(law_, rest, x).mean.frame,
                                                         velocities.leftCols<4>(), velocities.rightCols<6>());
  Degrees all;
  all << found.corners, found.edges;
  const Eigen::Matrix<double, 30, 1> expected = -stiffness_at(law_, rest, x) * velocities.reshaped();
  EXPECT_LT((all.reshaped() - expected).norm(), 1e-10 * expected.norm());
}

TEST_P(QuadraticElement, StiffnessIsSymmetricAndPositiveSemidefiniteInAnyShape) {
  for (int trial = 0; trial < 50; ++trial) {
    const RestElement rest = rest_element(random_corners(random_));
    Degrees x;
    x << random_.matrix(2) * random_corners(random_), random_offsets(random_, 0.3);
    const Stiffness stiffness = stiffness_at(law_, rest, x);
    EXPECT_LT((stiffness - stiffness.transpose()).norm(), 1e-12 * stiffness.norm());
    EXPECT_GT(symmetric_modes(stiffness).values[0], -1e-12 * stiffness.norm());
  }
}

TEST_P(QuadraticElement, CrushedOnesStayFinite) {
  const RestElement rest = rest_element(random_corners(random_));
  for (const double scale : {0.0, -1.0, 1e-8}) {
    Degrees x;
    x << scale * random_.matrix(2) * random_corners(random_), random_offsets(random_, 0.3);
    EXPECT_TRUE(forces_at(law_, rest, x).allFinite());
  }
}

}  // namespace
}  // namespace griffith
