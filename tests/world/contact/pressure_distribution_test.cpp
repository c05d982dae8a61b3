#include "sim/world/contact/pressure_distribution.h"

#include <gtest/gtest.h>

#include "sim/world/world.h"
#include "tests/random_values.h"
#include "tests/world/contact/contact_scenes.h"

namespace griffith {
namespace {

using testing::RandomValues;

/// A strip of length 1 and width `width`, of `count` points along it.
Eigen::Matrix3Xd strip(int count, double width) {
  Eigen::Matrix3Xd moments(3, 2 * count);
  for (int i = 0; i < count; ++i)
    for (int side = 0; side < 2; ++side) moments.col(2 * i + side) << 1, (i + 0.5) / count - 0.5, width * (side - 0.5);
  return moments;
}

TEST(PressureDistribution, KeepsTheResultantAndNeverPulls) {
  RandomValues random(1);
  for (int trial = 0; trial < 200; ++trial) {
    const double size = std::pow(10, random.uniform(-3, 1));
    const int count = 4 + random.index(30);
    Eigen::Matrix3Xd moments(3, count);
    Eigen::VectorXd areas(count), given(count);
    for (int i = 0; i < count; ++i) {
      moments.col(i) << 1, size * random.uniform(-1, 1), size * random.uniform(-1, 1);
      areas[i] = size * size * random.uniform(0.1, 1);
      given[i] = random.uniform(0, 1);
    }
    const Vec3 resultant = moments * given;
    const auto pressures = even_pressures(moments, areas, resultant);
    ASSERT_TRUE(pressures);
    EXPECT_GE(pressures->minCoeff(), 0);
    const Vec3 off = moments * *pressures - resultant;
    EXPECT_LT(std::abs(off[0]) + (off.tail<2>() / size).norm(), 1e-5 * resultant[0]);
  }
}

TEST(PressureDistribution, IsUniformUnderACentralLoad) {
  const Eigen::Matrix3Xd moments = strip(20, 0.1);
  const Eigen::VectorXd areas = Eigen::VectorXd::LinSpaced(40, 1, 1);
  const auto pressures = even_pressures(moments, areas, Vec3(4, 0, 0));
  ASSERT_TRUE(pressures);
  EXPECT_LT((pressures->array() - 0.1).abs().maxCoeff(), 1e-12);
}

// Navier: p = F/A (1 + 12 e x / l²) within the kern; outside it a triangle of length 3 (l/2 − e) carries all.
TEST(PressureDistribution, IsLinearInTheKernAndATriangleOutsideIt) {
  constexpr int kCount = 400;
  const Eigen::Matrix3Xd moments = strip(kCount, 0.1);
  const Eigen::VectorXd areas = Eigen::VectorXd::Ones(2 * kCount);
  for (const double off : {0.1, 0.3}) {
    const auto pressures = even_pressures(moments, areas, Vec3(1, off, 0));
    ASSERT_TRUE(pressures);
    const double length = off < 1.0 / 6 ? 1 : 3 * (0.5 - off);
    for (int i = 0; i < 2 * kCount; ++i) {
      const double x = moments(1, i), from_edge = x - (0.5 - length);
      const double line = off < 1.0 / 6 ? 1 + 12 * off * x : std::max(0.0, 2 * from_edge / (length * length));
      EXPECT_NEAR((*pressures)[i] * 2 * kCount, line, 0.03) << "at " << x << ", off " << off;
    }
  }
}

TEST(PressureDistribution, IsEmptyWhereTheLoadIsBesideThePoints) {
  const Eigen::VectorXd areas = Eigen::VectorXd::Ones(40);
  EXPECT_FALSE(even_pressures(strip(20, 0.1), areas, Vec3(1, 0.6, 0)));
}

// Ten plates of granite: their own weight presses them evenly, and bends none. The energy of compression is that of
// bars under their own weight, V σ²/2E, with σ = ρ g z; a plate that bent on its corners would hold a thousand times
// as much.
TEST(PressureDistribution, StackedPlatesDoNotBend) {
  Scene scene = testing::empty_scene({0.5, 1, 1.0 / 60});
  const double thickness = 0.03, side = 0.5;
  for (int i = 0; i < 10; ++i)
    scene.bodies.push_back(testing::box("plate " + std::to_string(i), Vec3(side, thickness, side),
                                        Vec3(0, (i + 0.5) * thickness, 0), testing::preset("granite"),
                                        Vec3(side / 4, thickness, side / 4)));
  World world(scene);
  for (int step = 0; step < 10; ++step) world.step();
  const Material granite = testing::preset("granite");
  const double height = 10 * thickness, weight = granite.density * testing::kEarthGravity;
  const double squeezed = weight * weight * side * side * height * height * height / (6 * granite.young_modulus);
  EXPECT_GT(world.frame().energy.elastic, 0.3 * squeezed);
  EXPECT_LT(world.frame().energy.elastic, 30 * squeezed);
}

}  // namespace
}  // namespace griffith
