#include "sim/elasticity/element.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/random_values.h"

namespace griffith {
namespace {

using testing::RandomValues;

Corners random_corners(RandomValues& random) {
  for (;;) {
    Corners corners;
    for (int i = 0; i < 4; ++i) corners.col(i) = random.vector();
    const Mat3 edges = corners.rightCols<3>().colwise() - corners.col(0);
    if (edges.determinant() > 0.1) return corners;
  }
}

ElasticModuli moduli() { return {2e6, 3e6}; }

Corners forces(const ElementRest& rest, const Corners& corners) {
  const ElementState state = corotational_state(rest, moduli(), corners);
  return nodal_forces(rest, state.rotation, state.stress);
}

TEST(Element, GradientsSumToZeroAndReproduceLinearFields) {
  RandomValues random(1);
  for (int i = 0; i < 100; ++i) {
    const Corners rest_corners = random_corners(random);
    const ElementRest rest = element_rest(rest_corners);
    EXPECT_LT(rest.shape_gradients.rowwise().sum().norm(), 1e-12);
    const Mat3 f = random.matrix();
    EXPECT_LT((deformation_gradient(rest, f * rest_corners) - f).norm(), 1e-11);
  }
}

TEST(Element, ForceIsMinusTheGradientOfTheEnergy) {
  RandomValues random(2);
  for (int trial = 0; trial < 50; ++trial) {
    const Corners rest_corners = random_corners(random);
    const ElementRest rest = element_rest(rest_corners);
    Corners corners = random.rotation() * rest_corners;
    for (int i = 0; i < 4; ++i) corners.col(i) += random.vector(0.05);
    const Corners force = forces(rest, corners);
    const auto energy = [&](const Corners& x) { return rest.volume * corotational_state(rest, moduli(), x).energy_density; };
    const double h = 1e-5;
    for (int i = 0; i < 12; ++i) {
      Corners plus = corners, minus = corners;
      plus(i) += h;
      minus(i) -= h;
      EXPECT_NEAR(-(energy(plus) - energy(minus)) / (2 * h), force(i), 1e-6 * force.norm());
    }
  }
}

TEST(Element, StiffnessIsTheDerivativeOfTheForceAtRest) {
  RandomValues random(3);
  for (int trial = 0; trial < 20; ++trial) {
    const Corners rest_corners = random_corners(random);
    const ElementRest rest = element_rest(rest_corners);
    const Mat3 rotation = random.rotation();
    const Corners corners = rotation * rest_corners, gradients = rotation * rest.shape_gradients;
    const double h = 1e-6;
    for (int j = 0; j < 4; ++j)
      for (int c = 0; c < 3; ++c) {
        Corners plus = corners, minus = corners;
        plus(c, j) += h;
        minus(c, j) -= h;
        const Corners derivative = (forces(rest, plus) - forces(rest, minus)) / (2 * h);
        for (int i = 0; i < 4; ++i) {
          const Mat3 block = rest.volume * stiffness_block(moduli(), gradients.col(i), gradients.col(j));
          EXPECT_LT((derivative.col(i) + block.col(c)).norm(), 1e-5 * block.norm() + 1e-3);
        }
      }
  }
}

TEST(Element, RigidMotionMakesNoStress) {
  RandomValues random(4);
  for (int i = 0; i < 200; ++i) {
    const Corners rest_corners = random_corners(random);
    const ElementRest rest = element_rest(rest_corners);
    const Corners moved = (random.rotation() * rest_corners).colwise() + random.vector(10);
    EXPECT_LT(corotational_state(rest, moduli(), moved).stress.norm(), 1e-6);
  }
}

TEST(Element, StressTurnsWithTheBody) {
  RandomValues random(5);
  for (int i = 0; i < 200; ++i) {
    const Corners rest_corners = random_corners(random);
    const ElementRest rest = element_rest(rest_corners);
    Corners corners = rest_corners;
    for (int k = 0; k < 4; ++k) corners.col(k) += random.vector(0.1);
    const Mat3 rotation = random.rotation();
    const Corners turned = forces(rest, rotation * corners);
    const Corners expected = rotation * forces(rest, corners);
    EXPECT_LT((turned - expected).norm(), 1e-9 * expected.norm() + 1e-9);
  }
}

TEST(Element, ForcesHaveNeitherResultantNorTorque) {
  RandomValues random(6);
  for (int i = 0; i < 200; ++i) {
    const Corners rest_corners = random_corners(random);
    const ElementRest rest = element_rest(rest_corners);
    Corners corners = rest_corners;
    for (int k = 0; k < 4; ++k) corners.col(k) += random.vector(0.5);
    const Corners force = forces(rest, corners);
    Vec3 torque = Vec3::Zero();
    for (int k = 0; k < 4; ++k) torque += Vec3(corners.col(k)).cross(Vec3(force.col(k)));
    EXPECT_LT(force.rowwise().sum().norm(), 1e-10 * force.norm());
    EXPECT_LT(torque.norm(), 1e-9 * force.norm());
  }
}

TEST(Element, UniaxialStrainOfARodGivesYoungsModulus) {
  Material material;
  material.young_modulus = 5e9;
  material.poisson_ratio = 0.3;
  Corners rest_corners;
  rest_corners << 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1;
  const ElementRest rest = element_rest(rest_corners);
  const double strain = 1e-4;
  const Vec3 stretch(1 + strain, 1 - 0.3 * strain, 1 - 0.3 * strain);
  const ElementState state = corotational_state(rest, elastic_moduli(material), stretch.asDiagonal() * rest_corners);
  EXPECT_NEAR(state.stress(0, 0), 5e9 * strain, 1e-6 * 5e9 * strain);
  EXPECT_LT(std::abs(state.stress(1, 1)), 1e-6 * 5e9 * strain);
  EXPECT_NEAR(rest.volume, 1.0 / 6, 1e-15);
}

TEST(Element, FoldedAndFlatElementsStayFiniteAndAreReported) {
  RandomValues random(7);
  const Corners rest_corners = random_corners(random);
  const ElementRest rest = element_rest(rest_corners);
  const Corners mirrored = Vec3(1, 1, -1).asDiagonal() * rest_corners;
  for (const Corners& corners : {mirrored, Corners(Vec3(1, 1, 0).asDiagonal() * rest_corners), Corners(Corners::Zero())}) {
    const ElementState state = corotational_state(rest, moduli(), corners);
    EXPECT_TRUE(state.stress.allFinite());
    EXPECT_TRUE(state.inverted);
  }
  EXPECT_FALSE(corotational_state(rest, moduli(), rest_corners).inverted);
}

}  // namespace
}  // namespace griffith
