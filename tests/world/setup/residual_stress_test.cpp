// Residual stress against its closed forms: a tempered plate, a hindered and a free thermal strain.

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "sim/core/error.h"
#include "sim/core/temporary_folder.h"
#include "sim/world/world.h"

namespace griffith {
namespace {

constexpr double kThickness = 0.01;  // of plates normal to z [m]

/// A free plate, eight times as wide as thick, in weightless space.
Scene plate(int layers, BoxPattern pattern) {
  Scene scene;
  scene.gravity.setZero();
  scene.ground.reset();
  BodyDescription body;
  const Vec3 size(8 * kThickness, 8 * kThickness, kThickness);
  body.shape = BoxShape{size, Vec3(kThickness / 2, kThickness / 2, kThickness / layers), pattern};
  body.material = *find_material_preset("soda_lime_glass");
  body.material.tensile_strength = 1e9;
  scene.bodies = {body};
  return scene;
}

/// A part of the plate within a quarter of its width from the middle.
struct Layer {
  double volume = 0;
  Mat3 stress = Mat3::Zero();  ///< mean [Pa]
  double parabola = 0;         ///< mean of 12 ζ² − 1
};

std::vector<Layer> layers_of(const Frame& frame, int count) {
  std::vector<Layer> layers(count);
  for (std::size_t tet = 0; tet < frame.elements.tets.size(); ++tet) {
    Vec3 center = Vec3::Zero();
    double squares = 0;
    for (const NodeId node : frame.elements.tets[tet]) {
      center += frame.nodes.rest_positions[node] / 4;
      squares += std::pow(frame.nodes.rest_positions[node].z() / kThickness, 2);
    }
    if (center.head<2>().cwiseAbs().maxCoeff() > 2 * kThickness) continue;
    Layer& layer = layers[static_cast<int>((center.z() / kThickness + 0.5) * count)];
    const double volume = frame.elements.rest_elements[tet].volume, mean = center.z() / kThickness;
    layer.volume += volume;
    layer.parabola += volume * (12 * (squares + 16 * mean * mean) / 20 - 1);
    layer.stress += volume * frame.elements.stresses[tet];
  }
  for (Layer& layer : layers) layer.stress /= layer.volume, layer.parabola /= layer.volume;
  return layers;
}

class TemperedPlate : public ::testing::TestWithParam<std::tuple<BoxPattern, Analysis>> {};

TEST_P(TemperedPlate, HasTheParabolicStress) {
  const auto [pattern, analysis] = GetParam();
  constexpr double kSurface = -100e6;
  for (const int count : {4, 8}) {
    Scene scene = plate(count, pattern);
    scene.analysis = analysis;
    scene.bodies[0].residual_stress = ParabolicStress{Vec3(0, 0, 2), kSurface};
    World world(scene);
    if (analysis == Analysis::static_) world.step();
    const std::vector<Layer> layers = layers_of(world.frame(), count);
    for (int i = 0; i < count; ++i) {
      const double expected = kSurface * layers[i].parabola / 2;
      EXPECT_NEAR(layers[i].stress(0, 0), expected, 0.02 * 100e6) << "layer " << i << " of " << count;
      EXPECT_NEAR(layers[i].stress(1, 1), expected, 0.02 * 100e6);
      EXPECT_NEAR(layers[i].stress(2, 2), 0, 0.02 * 100e6);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(PatternsAndAnalyses, TemperedPlate,
                         ::testing::Combine(::testing::Values(BoxPattern::five_tet, BoxPattern::kuhn, BoxPattern::bcc),
                                            ::testing::Values(Analysis::dynamic, Analysis::static_)));

/// ∫ σ dV is zero in any body without loads.
TEST(ResidualStress, BalancesItself) {
  for (const ElementOrder order : {ElementOrder::linear, ElementOrder::quadratic}) {
    Scene scene = plate(4, BoxPattern::kuhn);
    scene.bodies[0].elements = order;
    scene.bodies[0].rotation_degrees = Vec3(30, 40, 50);
    scene.bodies[0].residual_stress = ParabolicStress{Vec3(1, 2, 3), -100e6};
    const World world(scene);
    Mat3 sum = Mat3::Zero();
    double volume = 0, largest = 0;
    for (std::size_t tet = 0; tet < world.frame().elements.tets.size(); ++tet) {
      sum += world.frame().elements.rest_elements[tet].volume * world.frame().elements.stresses[tet];
      volume += world.frame().elements.rest_elements[tet].volume;
      largest = std::max(largest, world.frame().elements.stresses[tet].norm());
    }
    EXPECT_GT(largest, 10e6);
    EXPECT_LT(sum.norm() / volume, 1e-3 * largest);
  }
}

/// Strain that nothing hinders causes no stress.
TEST(ResidualStress, OfAUniformStrainIsZeroInAFreeBody) {
  Scene scene = plate(2, BoxPattern::five_tet);
  const Vec3 strain(1e-4, -2e-4, 3e-4), shear(1e-4, 0, -1e-4);
  scene.bodies[0].residual_stress = UniformStrain{strain, shear};
  scene.bodies[0].rotation_degrees = Vec3(0, 0, 90);
  const World world(scene);
  for (const Mat3& stress : world.frame().elements.stresses) EXPECT_LT(stress.norm(), 1e-3 * 70e9 * 3e-4);
}

/// Between rigid walls a strain ε* causes the stress −C : ε*.
TEST(ResidualStress, OfAHinderedStrainIsThatOfItsOpposite) {
  Scene scene = plate(2, BoxPattern::five_tet);
  BodyDescription& body = scene.bodies[0];
  Support wall;
  wall.region = SphereRegion{Vec3::Zero(), 1};
  body.supports = {wall};
  body.residual_stress = UniformStrain{Vec3::Constant(1e-4), Vec3::Zero()};
  const World world(scene);
  const double expected = -body.material.young_modulus / (1 - 2 * body.material.poisson_ratio) * 1e-4;
  for (const Mat3& stress : world.frame().elements.stresses)
    EXPECT_LT((stress - expected * Mat3::Identity()).norm(), 1e-6 * std::abs(expected));
}

/// A strain from a file is that of the tets in the order of the mesh.
TEST(ResidualStress, ComesFromAFile) {
  const TemporaryFolder folder;
  Scene scene = plate(2, BoxPattern::five_tet);
  scene.folder = folder.path();
  Support wall;
  wall.region = SphereRegion{Vec3::Zero(), 1};
  scene.bodies[0].supports = {wall};
  const int tets = static_cast<int>(World(scene).frame().elements.tets.size());
  const auto write = [&](int rows) {
    std::ofstream file(folder.path() / "strains.csv");
    for (int row = 0; row < rows; ++row) file << row * 1e-7 << ",0,0,0,0," << 1e-5 << "\n";
  };
  write(tets);
  scene.bodies[0].residual_stress = StrainFile{"strains.csv"};
  const World world(scene);
  const Material& glass = scene.bodies[0].material;
  for (int tet = 0; tet < tets; ++tet) {
    const Mat3& stress = world.frame().elements.stresses[tet];
    EXPECT_NEAR(stress(0, 1), -2 * shear_modulus(glass) * 1e-5, 1);
    EXPECT_NEAR(stress(0, 0), -(lame_lambda(glass) + 2 * shear_modulus(glass)) * tet * 1e-7, 1);
  }
  write(tets - 1);
  EXPECT_THROW(World{scene}, InputError);
}

/// A free plate keeps its velocity and stress, and its energy is accounted for.
TEST(ResidualStress, FliesAlong) {
  Scene scene = plate(4, BoxPattern::five_tet);
  scene.bodies[0].velocity = Vec3(1, 2, 3);
  scene.bodies[0].angular_velocity = Vec3(0, 0, 5);
  scene.bodies[0].residual_stress = ParabolicStress{};
  World world(scene);
  const double energy = world.frame().totals.elastic_energy;
  const Vec3 momentum = world.frame().totals.momentum;
  EXPECT_GT(energy, 0);
  EXPECT_LT((momentum - world.frame().totals.mass * Vec3(1, 2, 3)).norm(), 1e-9 * momentum.norm());
  for (int step = 0; step < 60; ++step) world.step();
  EXPECT_NEAR(world.frame().totals.elastic_energy, energy, 0.02 * energy);
  EXPECT_LT((world.frame().totals.momentum - momentum).norm(), 1e-6 * momentum.norm());
  EXPECT_LT(std::abs(world.frame().energy.unaccounted()), 0.01 * energy);
}

/// Another material before the first step: the stress stays that of the scene.
TEST(ResidualStress, FollowsAMaterialGivenBeforeTheFirstStep) {
  Scene scene = plate(4, BoxPattern::five_tet);
  scene.bodies[0].residual_stress = ParabolicStress{};
  World world(scene);
  const double stress = layers_of(world.frame(), 4)[0].stress(0, 0);
  Material stiffer = scene.bodies[0].material;
  stiffer.young_modulus *= 2;
  world.set_material(0, stiffer);
  EXPECT_NEAR(layers_of(world.frame(), 4)[0].stress(0, 0), stress, 1e-3 * std::abs(stress));
  stiffer.yield_strength = 1e8;
  EXPECT_THROW(world.set_material(0, stiffer), InputError);
}

/// Tension in the middle counts as load: a plate cracks by itself if it exceeds the strength.
TEST(ResidualStress, BreaksAPlateWhoseStrengthIsBelowItsTension) {
  for (const double strength : {30e6, 80e6}) {
    Scene scene = plate(8, BoxPattern::five_tet);
    scene.bodies[0].material.tensile_strength = strength;
    scene.bodies[0].residual_stress = ParabolicStress{Vec3::UnitZ(), -100e6};
    World world(scene);
    for (int step = 0; step < 5; ++step) world.step();
    EXPECT_EQ(!world.frame().crack_events.empty(), strength < 45e6) << strength;
  }
}

/// Residual stress loads pieces that nothing touches. Once waves have crossed them without damage they move as rigid
/// bodies, as pieces without it do.
TEST(ResidualStress, LetsTheDiceOfAPaneMoveAsRigidBodies) {
  Scene scene;
  scene.gravity.setZero();
  scene.ground.reset();
  scene.simulation.time_step = 5e-4;
  BodyDescription pane;
  pane.shape = BoxShape{Vec3(0.03, 0.03, 0.004), Vec3(0.005, 0.005, 0.00067), BoxPattern::five_tet};
  pane.material = *find_material_preset("soda_lime_glass");
  pane.material.tensile_strength = 80e6;
  pane.residual_stress = ParabolicStress{Vec3::UnitZ(), -100e6};
  scene.bodies = {pane};
  scene.projectiles = {
      {.position = Vec3(0.007, 0.007, 0.007), .direction = -Vec3::UnitZ(), .speed = 20, .mass = 0.01, .radius = 0.004}};
  World world(scene);
  for (int step = 0; step < 10; ++step) world.step();
  const Frame frame = world.frame();
  double mass = 0, rigid = 0;
  for (const BodyView& body : frame.bodies) {
    mass += body.mass;
    if (body.rigid) rigid += body.mass;
  }
  EXPECT_GT(frame.fragments, 36) << "more than its cells";
  EXPECT_GT(rigid, 0.8 * mass);
}

}  // namespace
}  // namespace griffith
