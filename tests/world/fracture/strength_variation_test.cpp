#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/world/loading.h"

namespace griffith::testing {
namespace {

/// A bar along x between pulled ends, at its tensile strength; its x axis is turned by `degrees` about z from the
/// grain.
Scene bar(const Vec3& element_size, BoxPattern pattern) {
  Scene scene;
  scene.gravity.setZero();
  scene.ground.reset();
  BodyDescription body;
  body.shape = BoxShape{Vec3(2, 0.5, 0.5), element_size, pattern};
  body.material = *find_material_preset("wood_along_grain");
  body.material.poisson_ratio = 0;
  for (double side : {-1.0, 1.0}) {
    Load pull;
    pull.kind = LoadKind::traction;
    pull.region = HalfSpaceRegion{Vec3(side, 0, 0), Vec3(side, 0, 0)};
    pull.traction = Vec3(side * body.material.tensile_strength, 0, 0);
    body.loads.push_back(pull);
  }
  scene.bodies = {body};
  return scene;
}

double peak_utilization(Scene scene) {
  scene.analysis = Analysis::static_;
  scene.simulation.fracture = false;
  World world(scene);
  world.step();
  return world.frame().report.peak_utilization;
}

TEST(StrengthScatter, BarsBreakAsWeibullSaysOnCoarseAndFineMeshes) {
  // The bar's volume is half the reference volume: mean strength σ_t 2^(1/m), the same on every mesh.
  const double m = 6, expected = std::pow(2, 1 / m);
  for (double size : {0.5, 0.25}) {
    double sum = 0, squares = 0;
    const int bars = 150;
    for (int seed = 0; seed < bars; ++seed) {
      Scene scene = bar(Vec3::Constant(size), BoxPattern::five_tet);
      scene.bodies[0].strength_scatter = StrengthScatter{m, 1, seed};
      const double strength = 1 / peak_utilization(scene);
      sum += strength;
      squares += strength * strength;
    }
    const double mean = sum / bars, deviation = std::sqrt(squares / bars - mean * mean);
    // The ends are not seen by the criterion: a share 1/(2 length/size) of the volume, which makes 1 to 4 %.
    EXPECT_NEAR(mean, expected, 0.06 * expected) << size;
    const double cv = std::sqrt(std::tgamma(1 + 2 / m) / std::pow(std::tgamma(1 + 1 / m), 2) - 1);
    EXPECT_NEAR(deviation / mean, cv, 0.15 * cv) << size;
  }
}

TEST(Weakness, AnOffAxisBarBreaksAtHankinsonsLoadAlongTheGrain) {
  const double ratio = 1.0 / 30;
  for (double degrees : {0.0, 10.0, 45.0, 90.0}) {
    const double angle = degrees * std::numbers::pi / 180;
    Scene scene = bar(Vec3::Constant(0.125), BoxPattern::five_tet);
    scene.bodies[0].weakness = Weakness{WeaknessKind::grain, Vec3(std::cos(angle), std::sin(angle), 0), ratio};
    const double hankinson = 1 / (std::pow(std::cos(angle), 2) + std::pow(std::sin(angle), 2) / ratio);
    EXPECT_NEAR(1 / peak_utilization(scene), hankinson, 0.01 * hankinson) << degrees;
    if (degrees < 10) continue;
    const Vec3 grain = scene.bodies[0].weakness->direction;
    for (Load& load : scene.bodies[0].loads) load.traction *= hankinson;
    breaking_fraction(scene, {0.95, 1.1, 0.01}, has_cracked, [&](const Frame& frame) {
      EXPECT_LT(std::abs(frame.crack_events.front().normal.dot(grain)), std::sin(0.2))
          << "the plane contains the grain";
    });
  }
}

TEST(Weakness, LayersPartAcrossTheirDirectionAndTurnWithTheBody) {
  Scene scene = bar(Vec3::Constant(0.25), BoxPattern::kuhn);
  scene.bodies[0].weakness = Weakness{WeaknessKind::layers, Vec3::UnitX(), 0.1};
  EXPECT_NEAR(peak_utilization(scene), 10, 1e-2);
  scene.bodies[0].weakness->direction = Vec3::UnitY();
  EXPECT_NEAR(peak_utilization(scene), 1, 1e-3);
  scene.bodies[0].rotation_degrees = Vec3(0, 0, 90);
  for (Load& load : scene.bodies[0].loads) load.traction = Vec3(0, load.traction.x(), 0);
  EXPECT_NEAR(peak_utilization(scene), 1, 1e-3) << "the direction is the body's, not the world's";
}

}  // namespace
}  // namespace griffith::testing
