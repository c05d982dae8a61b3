#include "sim/elasticity/element.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "sim/core/dense_algebra.h"
#include "sim/elasticity/stiffness.h"
#include "tests/elasticity/random_element.h"

namespace griffith {
namespace {

using testing::elastic_forces;
using testing::elastic_state;
using testing::random_corners;
using testing::RandomValues;
using testing::shaken;

class Element : public ::testing::TestWithParam<ElementModel> {
 protected:
  ElasticLaw law() const { return {GetParam(), 2e6, 3e6}; }
};
INSTANTIATE_TEST_SUITE_P(Models, Element, ::testing::Values(ElementModel::corotational, ElementModel::green_strain));

constexpr ElasticLaw kGreen{ElementModel::green_strain, 2e6, 3e6};

/// −∂f/∂x by central differences, row i of blocks for corner i.
Eigen::Matrix<double, 12, 12> difference_quotient(const ElasticLaw& law, const RestElement& rest,
                                                  const Corners& corners) {
  const double h = 1e-6;
  Eigen::Matrix<double, 12, 12> stiffness;
  for (int i = 0; i < 12; ++i) {
    Corners plus = corners, minus = corners;
    plus(i) += h;
    minus(i) -= h;
    stiffness.col(i) = ((elastic_forces(law, rest, minus) - elastic_forces(law, rest, plus)) / (2 * h)).reshaped();
  }
  return stiffness;
}

Eigen::Matrix<double, 12, 12> stiffness_of(const ElasticLaw& law, const RestElement& rest, const Corners& corners) {
  Eigen::Matrix<double, 12, 12> stiffness;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j)
      stiffness.block<3, 3>(3 * i, 3 * j) = stiffness_row(law, rest, elastic_state(law, rest, corners), i).block(j);
  return stiffness;
}

TEST(RestElement, GradientsSumToZeroAndReproduceLinearFields) {
  RandomValues random(1);
  for (int i = 0; i < 100; ++i) {
    const Corners rest_corners = random_corners(random);
    const RestElement rest = rest_element(rest_corners);
    EXPECT_LT(rest.shape_gradients.rowwise().sum().norm(), 1e-12);
    const Mat3 f = random.matrix();
    EXPECT_LT((deformation_gradient(rest, f * rest_corners) - f).norm(), 1e-11);
  }
}

TEST_P(Element, ForceIsMinusTheGradientOfTheEnergy) {
  RandomValues random(2);
  for (int trial = 0; trial < 50; ++trial) {
    const Corners rest_corners = random_corners(random);
    const RestElement rest = rest_element(rest_corners);
    const Corners corners = shaken(random.rotation() * rest_corners, random, 0.05);
    const Corners force = elastic_forces(law(), rest, corners);
    const auto energy = [&](const Corners& x) { return rest.volume * elastic_state(law(), rest, x).energy_density; };
    const double h = 1e-5;
    for (int i = 0; i < 12; ++i) {
      Corners plus = corners, minus = corners;
      plus(i) += h;
      minus(i) -= h;
      EXPECT_NEAR(-(energy(plus) - energy(minus)) / (2 * h), force(i), 1e-6 * force.norm());
    }
  }
}

TEST(StressFreeStrain, ForceIsMinusTheGradientOfTheEnergyAndHasNoTorque) {
  constexpr ElasticLaw kLaw{ElementModel::corotational, 2e6, 3e6};
  RandomValues random(8);
  for (int trial = 0; trial < 50; ++trial) {
    const Corners rest_corners = random_corners(random);
    const RestElement rest = rest_element(rest_corners);
    const Corners corners = shaken(random.rotation() * rest_corners, random, 0.05);
    const Mat3 shape = 0.05 * random.matrix(), free = shape + shape.transpose();
    const auto state_at = [&](const Corners& x) {
      return element_state(kLaw, element_deformation(kLaw.model, rest, x), free);
    };
    const ElementState state = state_at(corners);
    const Mat3 turning = turning_traction(kLaw.model, rest, corners, state);
    const Corners without = nodal_forces(rest, state.frame, state.stress.full());
    const Corners force = without - rest.volume * turning * rest.shape_gradients;
    const auto torque = [&](const Corners& forces) {
      Vec3 sum = Vec3::Zero();
      for (int i = 0; i < 4; ++i) sum += corners.col(i).cross(forces.col(i));
      return sum.norm() / (force.norm() * corners.norm());
    };
    EXPECT_LT(torque(force), 1e-12);
    EXPECT_GT(torque(without), 1e-5) << "too close to common axes for a test";
    const double h = 1e-5;
    for (int i = 0; i < 12; ++i) {
      Corners plus = corners, minus = corners;
      plus(i) += h;
      minus(i) -= h;
      const double change = rest.volume * (state_at(plus).energy_density - state_at(minus).energy_density);
      EXPECT_NEAR(-change / (2 * h), force(i), 1e-6 * force.norm());
    }
  }
}

TEST_P(Element, StiffnessIsTheDerivativeOfTheForceAtRest) {
  RandomValues random(3);
  for (int trial = 0; trial < 20; ++trial) {
    const Corners rest_corners = random_corners(random);
    const RestElement rest = rest_element(rest_corners);
    const Corners corners = random.rotation() * rest_corners;
    const auto stiffness = stiffness_of(law(), rest, corners);
    EXPECT_LT((difference_quotient(law(), rest, corners) - stiffness).norm(), 1e-7 * stiffness.norm());
  }
}

TEST(GreenElement, StiffnessIsExactInTension) {
  RandomValues random(4);
  for (int trial = 0; trial < 20; ++trial) {
    const Corners rest_corners = random_corners(random);
    const RestElement rest = rest_element(rest_corners);
    const Vec3 stretches(random.uniform(1.2, 2), random.uniform(1.2, 2), random.uniform(1.2, 2));
    const Corners corners = random.rotation() * stretches.asDiagonal() * random.rotation() * rest_corners;
    const auto stiffness = stiffness_of(kGreen, rest, corners);
    EXPECT_LT((difference_quotient(kGreen, rest, corners) - stiffness).norm(), 1e-7 * stiffness.norm());
  }
}

TEST_P(Element, StiffnessIsSymmetricAndPositiveSemidefiniteInAnyShape) {
  RandomValues random(5);
  for (int trial = 0; trial < 200; ++trial) {
    const RestElement rest = rest_element(random_corners(random));
    const auto stiffness = stiffness_of(law(), rest, random.matrix(2) * random_corners(random));
    EXPECT_LT((stiffness - stiffness.transpose()).norm(), 1e-12 * stiffness.norm());
    EXPECT_GT(symmetric_modes(stiffness).values[0], -1e-12 * stiffness.norm());
  }
}

TEST_P(Element, RigidMotionMakesNoStress) {
  RandomValues random(6);
  for (int i = 0; i < 200; ++i) {
    const Corners rest_corners = random_corners(random);
    const RestElement rest = rest_element(rest_corners);
    const Corners moved = (random.rotation() * rest_corners).colwise() + random.vector(10);
    EXPECT_LT(elastic_state(law(), rest, moved).stress.full().norm(), 1e-6);
  }
}

TEST_P(Element, ForceAndStressTurnWithTheBody) {
  RandomValues random(7);
  for (int i = 0; i < 200; ++i) {
    const Corners rest_corners = random_corners(random);
    const RestElement rest = rest_element(rest_corners);
    const Corners corners = shaken(rest_corners, random, 0.1);
    const Mat3 rotation = random.rotation();
    const ElementState state = elastic_state(law(), rest, corners),
                       turned = elastic_state(law(), rest, rotation * corners);
    const Corners expected = rotation * nodal_forces(rest, state.frame, state.stress);
    EXPECT_LT((nodal_forces(rest, turned.frame, turned.stress) - expected).norm(), 1e-9 * expected.norm());
    const Mat3 stress = rotation * cauchy_stress(state.frame, state.stress) * rotation.transpose();
    EXPECT_LT((cauchy_stress(turned.frame, turned.stress) - stress).norm(), 1e-9 * stress.norm());
  }
}

TEST_P(Element, ForcesHaveNeitherResultantNorTorque) {
  RandomValues random(8);
  for (int i = 0; i < 200; ++i) {
    const Corners rest_corners = random_corners(random);
    const Corners corners = shaken(rest_corners, random, 0.5);
    const Corners force = elastic_forces(law(), rest_element(rest_corners), corners);
    Vec3 torque = Vec3::Zero();
    for (int k = 0; k < 4; ++k) torque += Vec3(corners.col(k)).cross(Vec3(force.col(k)));
    EXPECT_LT(force.rowwise().sum().norm(), 1e-10 * force.norm());
    EXPECT_LT(torque.norm(), 1e-9 * force.norm());
  }
}

TEST_P(Element, UniaxialStrainOfARodGivesYoungsModulus) {
  Material material;
  material.element_model = GetParam();
  material.young_modulus = 5e9;
  material.poisson_ratio = 0.3;
  RandomValues random(9);
  const Corners rest_corners = random_corners(random);
  const double strain = 1e-6;
  const Vec3 stretch(1 + strain, 1 - 0.3 * strain, 1 - 0.3 * strain);
  const ElementState state =
      elastic_state(elastic_law(material), rest_element(rest_corners), stretch.asDiagonal() * rest_corners);
  EXPECT_NEAR(cauchy_stress(state.frame, state.stress)(0, 0), 5e9 * strain, 1e-5 * 5e9 * strain);
  EXPECT_LT(std::abs(state.stress.full()(1, 1)), 1e-5 * 5e9 * strain);
}

TEST(GreenElement, CauchyStressIsForcePerPresentArea) {
  // Corner i gets a third of the traction on the face opposite it; that face's outward area vector is −3 V cof(F) g_i.
  RandomValues random(10);
  for (int trial = 0; trial < 100; ++trial) {
    const Corners rest_corners = random_corners(random);
    const RestElement rest = rest_element(rest_corners);
    const Corners corners = shaken(rest_corners, random, 0.02);
    const ElementState state = elastic_state(kGreen, rest, corners);
    const Corners force = nodal_forces(rest, state.frame, state.stress);
    const Vec3 area = 0.5 * Vec3(corners.col(2) - corners.col(1)).cross(Vec3(corners.col(3) - corners.col(1)));
    const Vec3 expected = cauchy_stress(state.frame, state.stress) * area / 3;
    EXPECT_LT((force.col(0) - expected).norm(), 1e-10 * force.norm());
  }
}

TEST_P(Element, FoldedAndFlatElementsStayFiniteAndAreReported) {
  RandomValues random(11);
  const Corners rest_corners = random_corners(random);
  const RestElement rest = rest_element(rest_corners);
  const Corners mirrored = Vec3(1, 1, -1).asDiagonal() * rest_corners;
  const Corners flat = Vec3(1, 1, 0).asDiagonal() * rest_corners,
                nearly_flat = Vec3(1, 1, 1e-300).asDiagonal() * rest_corners;
  for (const Corners& corners : {mirrored, flat, nearly_flat, Corners(Corners::Zero())}) {
    const ElementState state = elastic_state(law(), rest, corners);
    EXPECT_TRUE(state.stress.full().allFinite() && state.frame.allFinite());
    EXPECT_TRUE(cauchy_stress(state.frame, state.stress).allFinite());
    EXPECT_EQ(state.inverted, corners != nearly_flat);
  }
  EXPECT_FALSE(elastic_state(law(), rest, rest_corners).inverted);
}

TEST(ElementSize, IsTheEdgeOfACubeOfSix) {
  constexpr double kEdge = 0.2, kSixth = kEdge * kEdge * kEdge / 6;
  std::vector<RestElement> elements(2);
  elements[0].volume = 0.5 * kSixth;
  elements[1].volume = 1.5 * kSixth;
  const std::vector<TetId> first = {TetId(0)};
  EXPECT_NEAR(mean_element_size(elements), kEdge, 1e-15);
  EXPECT_NEAR(mean_element_size(elements, first), kEdge * std::cbrt(0.5), 1e-15);
  EXPECT_EQ(mean_element_size(std::span<const RestElement>()), 0);
}

}  // namespace
}  // namespace griffith
