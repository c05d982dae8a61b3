#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <vector>

#include "sim/core/parallel.h"
#include "sim/world/world.h"

namespace griffith::testing {
namespace {

Material steel(double poisson_ratio = 0.3) {
  Material material = *find_material_preset("mild_steel");
  material.poisson_ratio = poisson_ratio;
  return material;
}

Region end_at(double x) { return HalfSpaceRegion{Vec3(x, 0, 0), Vec3(x, 0, 0)}; }

/// A load on a region that grows from `start` on within `ramp` [s].
Load growing_traction(const Region& region, const Vec3& traction, double start, double ramp) {
  Load load;
  load.kind = LoadKind::traction;
  load.region = region;
  load.traction = traction;
  load.start = start;
  load.ramp = ramp;
  return load;
}

Scene scene_of(const BodyDescription& body) {
  Scene scene;
  scene.gravity.setZero();
  scene.ground.reset();
  scene.analysis = Analysis::static_;
  scene.simulation.fracture = false;
  scene.bodies = {body};
  return scene;
}

double mean_displacement(const Frame& frame, double x, int axis) {
  double sum = 0;
  int count = 0;
  for (std::size_t i = 0; i < frame.nodes.positions.size(); ++i) {
    if (std::abs(frame.nodes.rest_positions[i].x() - x) > 1e-9) continue;
    sum += (frame.nodes.positions[i] - frame.nodes.rest_positions[i])[axis];
    ++count;
  }
  return sum / count;
}

/// Uniaxial strain of a bar between smooth walls, pulled with a traction at its end. Its stress is ⅔ σ_y + K ε once it
/// yields, with the bulk modulus K, and it unloads with the modulus M of plane waves.
struct ConfinedBar {
  static constexpr double kLength = 0.5, kLoaded = 1, kUnloaded = 2;  // [m], [s], [s]
  Material material = steel();
  double traction = 2.5 * *material.yield_strength;

  double yielded() const {  // strain under the traction
    return (traction - *material.yield_strength * 2 / 3) / bulk_modulus();
  }
  double permanent() const { return yielded() - traction / wave_modulus(); }
  double plastic_work() const {  // [J]
    const double plastic_strain = 2 * (yielded() - *material.yield_strength / (2 * shear_modulus(material))) / 3;
    return kLength * 0.01 * *material.yield_strength * plastic_strain;
  }
  double bulk_modulus() const { return material.young_modulus / (3 * (1 - 2 * material.poisson_ratio)); }
  double wave_modulus() const { return bulk_modulus() + 4 * shear_modulus(material) / 3; }

  Scene scene(BoxPattern pattern, ElementOrder order) const {
    BodyDescription bar;
    bar.shape = BoxShape{Vec3(kLength, 0.1, 0.1), Vec3::Constant(0.1), pattern};
    bar.elements = order;
    bar.material = material;
    const auto wall = [](const Vec3& place) {
      return Support{.region = HalfSpaceRegion{place, place}, .kind = SupportKind::sliding, .normal = place};
    };
    bar.supports = {wall(Vec3(-kLength / 2, 0, 0)), wall(Vec3(0, 0.05, 0)), wall(Vec3(0, -0.05, 0)),
                    wall(Vec3(0, 0, 0.05)), wall(Vec3(0, 0, -0.05))};
    const Vec3 pull(traction, 0, 0);
    bar.loads = {growing_traction(end_at(kLength / 2), pull, 0, kLoaded),
                 growing_traction(end_at(kLength / 2), -pull, kLoaded, kUnloaded - kLoaded)};
    return scene_of(bar);
  }
};

class Yielding : public ::testing::TestWithParam<std::tuple<BoxPattern, ElementOrder>> {
 protected:
  BoxPattern pattern() const { return std::get<0>(GetParam()); }
  ElementOrder order() const { return std::get<1>(GetParam()); }
};
INSTANTIATE_TEST_SUITE_P(Meshes, Yielding,
                         ::testing::Combine(::testing::Values(BoxPattern::kuhn, BoxPattern::five_tet, BoxPattern::bcc),
                                            ::testing::Values(ElementOrder::linear, ElementOrder::quadratic)));

TEST_P(Yielding, AConfinedBarHardensByItsBulkModulus) {
  const ConfinedBar bar;
  Scene scene = bar.scene(pattern(), order());
  scene.simulation.time_step = 0.1;
  World world(scene);
  const auto strain = [&] { return mean_displacement(world.frame(), bar.kLength / 2, 0) / bar.kLength; };
  while (world.frame().time < bar.kLoaded - 1e-9) world.step();
  EXPECT_NEAR(strain(), bar.yielded(), 1e-3 * bar.yielded());
  EXPECT_NEAR(world.frame().energy.plastic, bar.plastic_work(), 2e-3 * bar.plastic_work());
  while (world.frame().time < bar.kUnloaded - 1e-9) {
    world.step();
    EXPECT_EQ(world.frame().report.unconverged_solves, 0);
  }
  EXPECT_NEAR(strain(), bar.permanent(), 2e-3 * bar.yielded());
  EXPECT_NEAR(world.frame().energy.plastic, bar.plastic_work(), 2e-3 * bar.plastic_work());
  EXPECT_LT(std::abs(world.frame().energy.unaccounted()), 1e-3 * bar.plastic_work());
}

/// Steps that follow the motion end where equilibria do, if the load grows slowly.
TEST_P(Yielding, EveryIntegratorKeepsThePermanentStrain) {
  ConfinedBar bar;
  bar.material.young_modulus /= 1e4, *bar.material.yield_strength /= 1e4, bar.traction /= 1e4;
  for (const Integrator integrator : {Integrator::implicit, Integrator::explicit_, Integrator::hybrid}) {
    Scene scene = bar.scene(pattern(), order());
    scene.analysis = Analysis::dynamic;
    scene.simulation.integrator = integrator;
    scene.simulation.time_step = 0.01;
    scene.bodies[0].material = bar.material;
    World world(scene);
    while (world.frame().time < bar.kUnloaded + 0.1) world.step();
    const Frame frame = world.frame();
    const double strain = mean_displacement(frame, bar.kLength / 2, 0) / bar.kLength;
    EXPECT_NEAR(strain, bar.permanent(), 0.05 * bar.yielded()) << static_cast<int>(integrator);
    EXPECT_NEAR(frame.energy.plastic, bar.plastic_work(), 0.1 * bar.plastic_work()) << static_cast<int>(integrator);
    EXPECT_LT(std::abs(frame.energy.unaccounted()), 0.01 * bar.plastic_work()) << static_cast<int>(integrator);
  }
}

/// A free beam of square section without Poisson's effect, pulled at the upper and pressed at the lower half of its
/// ends. The moment is σ t³/4 of tractions ±σ, 1.5 σ/σ_y times the one at which the surface yields.
struct BentBeam {
  static constexpr double kThickness = 0.02, kLength = 0.12;
  BoxPattern pattern;
  int layers = 2;  ///< even
  ElementOrder order = ElementOrder::quadratic;

  /// Moments grow to `most` times the first yield within a second.
  Scene scene(double most) const {
    BodyDescription beam;
    beam.shape = BoxShape{Vec3(kLength, kThickness, kThickness), Vec3::Constant(kThickness / layers), pattern};
    beam.elements = order;
    beam.material = steel(0);
    const double traction = most / 1.5 * *beam.material.yield_strength;
    for (const double side : {-1.0, 1.0})
      for (const double half : {-1.0, 1.0}) {
        const Vec3 center(side * kLength / 2, 0, half * kThickness / 4);
        const Vec3 reach(1e-6, kThickness, kThickness / 4 + 1e-6);
        beam.loads.push_back(
            growing_traction(BoxRegion{center - reach, center + reach}, Vec3(side * half * traction, 0, 0), 0, 1));
      }
    return scene_of(beam);
  }
  /// Curvature of the middle half [1/m].
  double curvature(const Frame& frame) const {
    const double ends = (mean_displacement(frame, -kLength / 4, 2) + mean_displacement(frame, kLength / 4, 2)) / 2;
    return 8 * (ends - mean_displacement(frame, 0, 2)) / std::pow(kLength / 2, 2);
  }
};

/// Beyond the first yield the curvature grows by 1/√(3 − 2m) of the moment m, and without limit at 1.5.
TEST(YieldingBeam, BearsOneAndAHalfTimesTheMomentOfFirstYield) {
  for (const BoxPattern pattern : {BoxPattern::kuhn, BoxPattern::five_tet, BoxPattern::bcc}) {
    const BentBeam beam{pattern};
    Scene scene = beam.scene(2);
    scene.simulation.time_step = 0.125;
    World world(scene);
    const auto curvature_at = [&](double moment) {
      while (2 * world.frame().time < moment - 1e-9) world.step();
      return beam.curvature(world.frame());
    };
    const double elastic = curvature_at(0.5) / 0.5;
    EXPECT_NEAR(curvature_at(1.25) / elastic, std::sqrt(2), 0.1);
    EXPECT_EQ(world.frame().report.unconverged_solves, 0);
    EXPECT_LT(std::abs(world.frame().energy.unaccounted()), 1e-3 * world.frame().energy.loads);
    EXPECT_GT(curvature_at(1.5) / elastic, 5);
  }
}

TEST(YieldingBeam, IsTheSameOnAnyNumberOfThreads) {
  Scene scene = BentBeam{BoxPattern::five_tet, 4}.scene(1.4);
  scene.simulation.time_step = 0.1;
  scene.analysis = Analysis::dynamic;
  scene.simulation.integrator = Integrator::implicit;
  std::vector<std::uint64_t> hashes;
  for (const int threads : {1, 2, 4}) {
    const ThreadLimit limit(threads);
    World world(scene);
    while (world.frame().time < 1) world.step();
    EXPECT_GT(world.frame().energy.plastic, 0);
    hashes.push_back(world.state_hash());
  }
  EXPECT_EQ(hashes[0], hashes[1]);
  EXPECT_EQ(hashes[0], hashes[2]);
}

}  // namespace
}  // namespace griffith::testing
