#include <gtest/gtest.h>

#include <functional>
#include <random>

#include "sim/mesh/topology.h"
#include "sim/world/world.h"
#include "tests/world/fracture/crack_area.h"
#include "tests/world/scenes.h"

namespace griffith {
namespace {

/// A wall of 6 × 6 × 1 m that a sphere of 25 kg strikes near the middle.
Scene struck_wall(const Material& material, double speed, std::mt19937& random) {
  std::uniform_real_distribution<double> uniform(-1, 1);
  Scene scene;
  scene.bodies = {testing::wall(Vec3(6, 6, 1), 1, material)};
  std::get<BoxShape>(scene.bodies[0].shape).pattern = BoxPattern::five_tet;
  ProjectileBurst shot;
  shot.start = 0.02;
  shot.position = Vec3(1.5 * uniform(random), 3.8 + 0.8 * uniform(random), 2);
  shot.direction = -Vec3::UnitZ();
  shot.speed = speed * (1 + 0.1 * uniform(random));
  scene.projectiles = {shot};
  return scene;
}

/// The crack area that one shot leaves behind [m²], the mean over some that differ a little: one shot alone depends on
/// where it strikes more than on the wall.
double damage(const Material& material, double speed) {
  constexpr int kShots = 5;
  std::mt19937 random(1);
  double sum = 0;
  for (int shot = 0; shot < kShots; ++shot) {
    World world(struck_wall(material, speed, random));
    for (int step = 0; step < 60; ++step) world.step();
    sum += testing::crack_area(world.frame());
  }
  return sum / kShots;
}

Material brickwork() {
  Material material;
  material.tensile_strength = 60e3;
  material.fracture_toughness = 45e3;
  return material;
}

void separation_toughness(Material& material, double value) {
  material.criterion = FractureCriterion::separation_force;
  material.separation_toughness = value;
}

/// A property varied alone, from the weak over the regular to the strong wall.
struct Variation {
  std::string name;
  double speed;  ///< [m/s]
  std::array<double, 3> values;
  std::function<void(Material&, double)> set;
};

std::ostream& operator<<(std::ostream& stream, const Variation& variation) { return stream << variation.name; }

class OrderedDamage : public ::testing::TestWithParam<Variation> {};

TEST_P(OrderedDamage, WeakRegularAndStrongWallsBreakInThatOrder) {
  const Variation& variation = GetParam();
  std::vector<double> areas;
  for (double value : variation.values) {
    Material material = brickwork();
    variation.set(material, value);
    areas.push_back(damage(material, variation.speed));
  }
  EXPECT_GT(areas[1], 0);
  EXPECT_GT(areas[0], 1.2 * areas[1]);
  EXPECT_GT(areas[1], 1.2 * areas[2]);
}

INSTANTIATE_TEST_SUITE_P(
    Properties, OrderedDamage,
    ::testing::Values(
        Variation{"young_modulus", 9, {55e9, 16e9, 5e9}, [](Material& m, double x) { m.young_modulus = x; }},
        Variation{"poisson_ratio", 12, {0.45, 0.25, 0.05}, [](Material& m, double x) { m.poisson_ratio = x; }},
        Variation{"density", 7, {500, 1000, 2000}, [](Material& m, double x) { m.density = x; }},
        Variation{"tensile_strength", 9, {40e3, 60e3, 90e3}, [](Material& m, double x) { m.tensile_strength = x; }},
        Variation{"separation_toughness", 15, {15e3, 30e3, 60e3}, separation_toughness},
        Variation{
            "fracture_toughness", 9, {15e3, 30e3, 45e3}, [](Material& m, double x) { m.fracture_toughness = x; }}),
    [](const auto& variation) { return variation.param.name; });

}  // namespace
}  // namespace griffith
