// Bodies whose strength depends on the whole state of stress: in every regime they fail where the surface says.

#include <gtest/gtest.h>

#include <cmath>

#include "sim/fracture/strength_surface.h"
#include "sim/scene/scene_writer.h"
#include "sim/world/output/node_report.h"
#include "sim/world/world.h"

namespace griffith {
namespace {

constexpr double kTension = 40e6, kCompression = 1000e6, kSide = 0.1;  // [Pa], [m]

struct Regime {
  const char* name;
  Analysis analysis;
  Integrator integrator;
  ElementOrder elements;
};

constexpr Regime kRegimes[] = {
    {"static", Analysis::static_, Integrator::hybrid, ElementOrder::linear},
    {"hybrid", Analysis::dynamic, Integrator::hybrid, ElementOrder::linear},
    {"implicit", Analysis::dynamic, Integrator::implicit, ElementOrder::linear},
    {"explicit", Analysis::dynamic, Integrator::explicit_, ElementOrder::linear},
    {"quadratic", Analysis::dynamic, Integrator::hybrid, ElementOrder::quadratic},
};

/// Returns the strain under principal stresses [Pa].
Vec3 strain_of(const Vec3& stress, const Material& material) {
  const double ratio = material.poisson_ratio;
  return ((1 + ratio) * stress - Vec3::Constant(ratio * stress.sum())) / material.young_modulus;
}

/// A block of glass between rigid smooth walls, at rest under uniform principal stresses [Pa] by a strain of its own.
Scene stressed_block(const Regime& regime, const Vec3& stress, bool has_surface) {
  Scene scene;
  scene.gravity.setZero();
  scene.ground.reset();
  scene.analysis = regime.analysis;
  scene.simulation.integrator = regime.integrator;
  scene.simulation.time_step = 2e-4;
  scene.simulation.max_cracks_per_step = 1;
  BodyDescription block;
  block.shape = BoxShape{Vec3::Constant(kSide), Vec3::Constant(kSide / 3), BoxPattern::five_tet};
  block.elements = regime.elements;
  block.material = *find_material_preset("soda_lime_glass");
  block.material.tensile_strength = kTension;
  if (has_surface) block.material.compressive_strength = kCompression;
  block.residual_stress = UniformStrain{-strain_of(stress, block.material), Vec3::Zero()};
  for (int axis = 0; axis < 3; ++axis)
    for (const double side : {-1.0, 1.0}) {
      Support wall;
      wall.kind = SupportKind::sliding;
      wall.region = HalfSpaceRegion{side * kSide / 2 * Vec3::Unit(axis), side * Vec3::Unit(axis)};
      wall.normal = Vec3::Unit(axis);
      wall.can_tear = false;
      block.supports.push_back(wall);
    }
  scene.bodies = {block};
  return scene;
}

bool cracks(const Scene& scene) {
  World world(scene);
  for (int i = 0; i < 3; ++i) world.step();
  return !world.frame().crack_events.empty();
}

class StrengthSurfaceWorld : public ::testing::TestWithParam<Regime> {};

TEST_P(StrengthSurfaceWorld, FailsWhereTheSurfaceSays) {
  const Vec3 states[] = {Vec3(1, 0, 0), Vec3(1, 1, 0), Vec3(1, 1, 1), Vec3(1, 0, -1)};
  for (const Vec3& state : states) {
    const double onset = kTension / equivalent_tension(state.asDiagonal(), kTension / kCompression);
    EXPECT_FALSE(cracks(stressed_block(GetParam(), 0.97 * onset * state, true))) << state.transpose();
    EXPECT_TRUE(cracks(stressed_block(GetParam(), 1.03 * onset * state, true))) << state.transpose();
    EXPECT_EQ(cracks(stressed_block(GetParam(), 1.03 * onset * state, false)), 1.03 * onset > kTension)
        << "by its largest tension";
  }
}

TEST_P(StrengthSurfaceWorld, SplitsAlongAPressureAtItsCompressiveStrength) {
  const auto block = [](double stress) { return stressed_block(GetParam(), Vec3(0, -stress, 0), true); };
  EXPECT_FALSE(cracks(block(0.97 * kCompression)));
  World world(block(1.03 * kCompression));
  for (int i = 0; i < 3; ++i) world.step();
  const Frame frame = world.frame();
  ASSERT_FALSE(frame.crack_events.empty());
  EXPECT_LT(std::abs(frame.crack_events[0].normal.y()), 0.1);
  EXPECT_FALSE(cracks(stressed_block(GetParam(), Vec3::Constant(-1.5 * kCompression), true))) << "from all sides";
}

INSTANTIATE_TEST_SUITE_P(Regimes, StrengthSurfaceWorld, ::testing::ValuesIn(kRegimes),
                         [](const auto& regime) { return std::string(regime.param.name); });

TEST(StrengthSurfaceReport, AgreesWithTheUtilization) {
  Scene scene = stressed_block(kRegimes[1], Vec3(20e6, 15e6, -5e6), true);
  scene.simulation.fracture = false;
  World world(scene);
  world.step();
  const Frame frame = world.frame();
  for (const NodeId node : IdRange<NodeId>(0, static_cast<std::int64_t>(frame.nodes.positions.size()))) {
    const NodeReport report = node_report(frame, node);
    EXPECT_NEAR(report.load / report.separation.stress, 1, 1e-3);
    EXPECT_NEAR(report.load / report.plane.stress, 1.316, 0.01);
    double sum = report.balance;
    for (const ElementContribution& element : report.elements) sum += element.contribution;
    EXPECT_NEAR(sum / report.sum(), 1, 1e-9);
  }
}

}  // namespace
}  // namespace griffith
