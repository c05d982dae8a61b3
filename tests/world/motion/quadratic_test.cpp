#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "sim/core/parallel.h"
#include "sim/world/world.h"
#include "tests/world/loading.h"

namespace griffith::testing {
namespace {

/// A strip one layer of elements thick, 10 elements long, held at its left end.
struct Strip {
  BoxPattern pattern = BoxPattern::five_tet;
  double aspect = 4;  ///< width over thickness of the elements
  ElementOrder elements = ElementOrder::quadratic;
  double thickness = 0.01;

  double length() const { return 10 * aspect * thickness; }
  double width() const { return aspect * thickness; }
  double second_moment() const { return width() * std::pow(thickness, 3) / 12; }
};

Region end_of(const Strip& strip, double side) {
  return HalfSpaceRegion{Vec3(side * strip.length() / 2, 0, 0), Vec3(side, 0, 0)};
}

/// Glass without Poisson's effect, so that a strip of any width is a beam.
Scene strip_scene(const Strip& strip) {
  Scene scene;
  scene.gravity.setZero();
  scene.ground.reset();
  scene.analysis = Analysis::static_;
  BodyDescription body;
  body.shape = BoxShape{Vec3(strip.length(), strip.width(), strip.thickness),
                        Vec3(strip.width(), strip.width(), strip.thickness), strip.pattern};
  body.elements = strip.elements;
  body.material = *find_material_preset("soda_lime_glass");
  body.material.poisson_ratio = 0;
  body.supports = {{end_of(strip, -1)}};
  scene.bodies = {body};
  return scene;
}

/// A force across the free end [N].
Load tip_load(const Strip& strip, double force) {
  Load load;
  load.kind = LoadKind::traction;
  load.region = end_of(strip, 1);
  load.traction = Vec3(0, 0, -force / (strip.width() * strip.thickness));
  return load;
}

/// The tip force at which Mc/I at mid-length is `stress`.
double force_for(const Strip& strip, double stress) {
  return stress * strip.second_moment() / (strip.thickness / 2) / (strip.length() / 2);
}

double mean_tip_deflection(const Frame& frame, const Strip& strip) {
  double sum = 0;
  int count = 0;
  for (std::size_t i = 0; i < frame.nodes.positions.size(); ++i) {
    if (frame.nodes.rest_positions[i].x() < strip.length() / 2 - 1e-9) continue;
    sum += frame.nodes.rest_positions[i].z() - frame.nodes.positions[i].z();
    ++count;
  }
  return sum / count;
}

double exact_deflection(const Strip& strip, double force, const Material& material) {
  const double shear_stiffness = 5.0 / 6 * material.young_modulus / 2 * strip.width() * strip.thickness;
  return force * std::pow(strip.length(), 3) / (3 * material.young_modulus * strip.second_moment()) +
         force * strip.length() / shear_stiffness;
}

class OneLayer : public ::testing::TestWithParam<std::tuple<BoxPattern, double>> {
 protected:
  Strip strip() const { return {std::get<0>(GetParam()), std::get<1>(GetParam())}; }
};
INSTANTIATE_TEST_SUITE_P(Meshes, OneLayer,
                         ::testing::Combine(::testing::Values(BoxPattern::five_tet, BoxPattern::kuhn),
                                            ::testing::Values(1.0, 2.0, 4.0, 8.0)));

TEST_P(OneLayer, BendsAsBeamTheorySays) {
  Scene scene = strip_scene(strip());
  const double force = force_for(strip(), 1e5);
  scene.bodies[0].loads = {tip_load(strip(), force)};
  World world(scene);
  world.step();
  EXPECT_EQ(world.frame().report.unconverged_solves, 0);
  EXPECT_NEAR(mean_tip_deflection(world.frame(), strip()) / exact_deflection(strip(), force, scene.bodies[0].material),
              1, 0.01);
}

/// Nodes at mid-length on the side under tension see the stress of the surface.
TEST_P(OneLayer, ShowsTheStressOfTheSurface) {
  Scene scene = strip_scene(strip());
  const double stress = 1e5;
  scene.bodies[0].loads = {tip_load(strip(), force_for(strip(), stress))};
  scene.simulation.fracture = false;
  World world(scene);
  world.step();
  const Frame frame = world.frame();
  double sum = 0;
  int count = 0;
  for (std::size_t i = 0; i < frame.nodes.positions.size(); ++i) {
    const Vec3& place = frame.nodes.rest_positions[i];
    if (std::abs(place.x()) > 1e-9 || place.z() < 0) continue;
    EXPECT_NEAR(frame.nodes.separations[i].stress / stress, 1, 0.1);
    EXPECT_GT(std::abs(frame.nodes.separations[i].direction.x()), 0.97);
    sum += frame.nodes.separations[i].stress / stress;
    ++count;
  }
  EXPECT_GE(count, 2);
  EXPECT_NEAR(sum / count, 1, 0.05);
}

/// Strips break at their held end; there Mc/I is twice that at mid-length.
TEST(QuadraticStrip, BreaksWhereItsSurfaceReachesTheStrength) {
  for (const BoxPattern pattern : {BoxPattern::five_tet, BoxPattern::kuhn}) {
    const Strip strip{pattern, 4};
    Scene scene = strip_scene(strip);
    scene.bodies[0].supports.clear();
    // Bent by a couple at each end, so that all of it has the same stress.
    const double moment = scene.bodies[0].material.tensile_strength * strip.second_moment() / (strip.thickness / 2);
    for (const double side : {-1.0, 1.0})
      for (const double face : {-1.0, 1.0}) {
        Load pull;
        pull.kind = LoadKind::point_force;
        const Vec3 at(side * strip.length() / 2, 0, face * strip.thickness / 2), reach(1e-6, strip.width(), 1e-6);
        pull.region = BoxRegion{at - reach, at + reach};
        pull.force = Vec3(side * face * moment / strip.thickness, 0, 0);
        scene.bodies[0].loads.push_back(pull);
      }
    const double fraction = breaking_fraction(scene, {0.8, 1.2, 0.01}, has_cracked);
    EXPECT_NEAR(fraction, 1, 0.06);
  }
}

/// A free plate that nothing touches, bent at the start by the velocities of its corners.
Scene free_strip(double spin) {
  Strip strip;
  Scene scene = strip_scene(strip);
  scene.analysis = Analysis::dynamic;
  scene.simulation.integrator = Integrator::implicit;
  scene.simulation.relative_residual = 1e-8;
  scene.simulation.max_solver_iterations = 4000;
  scene.bodies[0].supports.clear();
  scene.bodies[0].material.tensile_strength = 1e12;
  scene.bodies[0].angular_velocity = Vec3(0, spin, 0.3 * spin);
  scene.bodies[0].velocity = Vec3(1, 2, 3);
  return scene;
}

TEST(QuadraticBody, FallsExactlyAndStaysStraight) {
  Scene scene = free_strip(0);
  scene.gravity = Vec3(0, -9.81, 0);
  World world(scene);
  const double dt = scene.simulation.time_step, time = 20 * dt;
  for (int i = 0; i < 20; ++i) world.step();
  const Frame frame = world.frame();
  const Vec3 moved = time * scene.bodies[0].velocity + 0.5 * time * (time + dt) * scene.gravity;
  for (std::size_t i = 0; i < frame.nodes.positions.size(); ++i)
    EXPECT_LT((frame.nodes.positions[i] - frame.nodes.rest_positions[i] - moved).norm(), 1e-12);
  for (const Vec3& offset : frame.edges.offsets) EXPECT_LT(offset.norm(), 1e-15);
}

TEST(QuadraticBody, KeepsItsMomentaAsItSpinsAndBends) {
  Scene scene = free_strip(40);
  World world(scene);
  const Totals before = world.frame().totals;
  for (int i = 0; i < 40; ++i) world.step();
  const Frame frame = world.frame();
  EXPECT_LT((frame.totals.momentum - before.momentum).norm(), 1e-10 * before.momentum.norm());
  EXPECT_LT((frame.totals.angular_momentum - before.angular_momentum).norm(), 1e-9 * before.angular_momentum.norm());
  EXPECT_LE(frame.totals.kinetic_energy, before.kinetic_energy * (1 + 1e-5));
}

/// A held strip that a load sets swinging, with cracks.
Scene swinging_strip() {
  Strip strip;
  Scene scene = strip_scene(strip);
  scene.analysis = Analysis::dynamic;
  scene.simulation.integrator = Integrator::implicit;
  scene.simulation.static_start = false;
  scene.simulation.time_step = 1e-3;
  scene.simulation.relative_residual = 1e-8;
  scene.simulation.max_solver_iterations = 4000;
  scene.bodies[0].loads = {tip_load(strip, force_for(strip, scene.bodies[0].material.tensile_strength))};
  return scene;
}

/// Edges of tets end at their corners.
void expect_edges_of_their_tets(const Frame& frame) {
  for (std::size_t tet = 0; tet < frame.elements.tets.size(); ++tet)
    for (int i = 0; i < 6; ++i)
      for (const NodeId end : frame.edges.ends[frame.elements.edges[tet][i]])
        EXPECT_NE(std::ranges::find(frame.elements.tets[tet], end), frame.elements.tets[tet].end());
}

TEST(QuadraticBody, AccountsForItsEnergy) {
  Scene scene = swinging_strip();
  scene.simulation.fracture = false;
  World world(scene);
  for (int i = 0; i < 30; ++i) world.step();
  const EnergyAccount energy = world.frame().energy;
  EXPECT_GT(energy.elastic, 0);
  EXPECT_LT(std::abs(energy.unaccounted()), 1e-3 * energy.loads);
}

TEST(QuadraticBody, CracksPartItsEdges) {
  Scene scene = swinging_strip();
  scene.bodies[0].supports[0].can_tear = false;
  World world(scene);
  const auto edges_before = world.frame().edges.ends.size();
  const double mass = world.frame().totals.mass;
  for (int i = 0; i < 30; ++i) world.step();
  const Frame frame = world.frame();
  ASSERT_FALSE(frame.crack_events.empty());
  EXPECT_GT(frame.fragments, 0);
  EXPECT_GT(frame.edges.ends.size(), edges_before);
  EXPECT_NEAR(frame.totals.mass, mass, 1e-12 * mass);
  expect_edges_of_their_tets(frame);
}

/// A pane of real glass, its four edges held, that a ball of 0.1 kg strikes at 30 m/s.
Scene struck_pane() {
  Scene scene;
  scene.gravity.setZero();
  scene.ground.reset();
  BodyDescription pane;
  pane.shape = BoxShape{Vec3(0.5, 0.5, 0.006), Vec3(0.05, 0.05, 0.006), BoxPattern::kuhn};
  pane.elements = ElementOrder::quadratic;
  pane.material = *find_material_preset("soda_lime_glass");
  for (const Vec3& side : {Vec3(-1, 0, 0), Vec3(1, 0, 0), Vec3(0, -1, 0), Vec3(0, 1, 0)})
    pane.supports.push_back({HalfSpaceRegion{0.25 * side, side}});
  scene.bodies = {pane};
  ProjectileBurst ball;
  ball.position = Vec3(0, 0, 0.02);
  ball.speed = 30;
  ball.mass = 0.1;
  ball.radius = 0.0146;
  scene.projectiles = {ball};
  scene.simulation.time_step = 1e-3;
  return scene;
}

TEST(QuadraticBody, BreaksInMicrosteps) {
  std::vector<std::uint64_t> hashes;
  for (const int threads : {1, 2, 4}) {
    const ThreadLimit limit(threads);
    World world(struck_pane());
    const double mass = world.frame().totals.mass;
    for (int i = 0; i < 2; ++i) world.step();
    const Frame frame = world.frame();
    EXPECT_FALSE(frame.crack_events.empty());
    EXPECT_NEAR(frame.totals.mass, mass + 0.1, 1e-9);
    EXPECT_LT(std::abs(frame.energy.unaccounted()), 2e-3 * 45);
    EXPECT_EQ(frame.report.non_finite_values, 0);
    expect_edges_of_their_tets(frame);
    hashes.push_back(world.state_hash());
  }
  EXPECT_EQ(hashes[0], hashes[1]);
  EXPECT_EQ(hashes[0], hashes[2]);
}

TEST(QuadraticBody, CopiesAndThreadsGoOnAlike) {
  std::vector<StateHashes> hashes;
  for (const int threads : {1, 2, 4}) {
    const ThreadLimit limit(threads);
    World world(swinging_strip());
    for (int i = 0; i < 6; ++i) world.step();
    World copy = world;
    for (int i = 0; i < 6; ++i) world.step(), copy.step();
    hashes.push_back(world.state_hashes());
    EXPECT_EQ(copy.state_hashes(), hashes.back());
  }
  EXPECT_EQ(hashes[0], hashes[1]);
  EXPECT_EQ(hashes[0], hashes[2]);
}

/// A force that sets in at once takes a cantilever to about twice its deflection at rest, half a period later: the sum
/// of (1 − cos ωt) over the first three modes, of .971, .025 and .003 of the deflection.
TEST(QuadraticBody, SwingsExplicitlyAtEulersFrequency) {
  const Strip strip{BoxPattern::five_tet, 1};
  Scene scene = strip_scene(strip);
  const double force = force_for(strip, 1e6);
  Material& material = scene.bodies[0].material;
  material.mass_damping = material.stiffness_damping = 0;
  const double frequency = 3.516 / std::pow(strip.length(), 2) * strip.thickness / std::sqrt(12) *
                           std::sqrt(material.young_modulus / material.density);
  scene.bodies[0].loads = {tip_load(strip, force)};
  scene.analysis = Analysis::dynamic;
  scene.simulation.integrator = Integrator::explicit_;
  scene.simulation.static_start = false;
  scene.simulation.fracture = false;
  scene.simulation.time_step = std::numbers::pi / frequency / 4;
  World world(scene);
  for (int i = 0; i < 4; ++i) world.step();
  const Frame frame = world.frame();
  EXPECT_NEAR(mean_tip_deflection(frame, strip) / exact_deflection(strip, force, material), 1.952, 0.03);
  EXPECT_GT(frame.report.substeps, 10);
  EXPECT_LT(std::abs(frame.energy.unaccounted()), 1e-3 * frame.energy.loads);
}

TEST(QuadraticBody, KeepsMomentaAndEnergyExplicitly) {
  for (const double damping : {0.0, 1e-6}) {
    Scene scene = free_strip(40);
    scene.simulation.integrator = Integrator::explicit_;
    scene.simulation.time_step = 2e-4;
    scene.bodies[0].material.stiffness_damping = damping;
    World world(scene);
    const Totals before = world.frame().totals;
    for (int i = 0; i < 5; ++i) world.step();
    const Frame frame = world.frame();
    EXPECT_LT((frame.totals.momentum - before.momentum).norm(), 1e-10 * before.momentum.norm());
    EXPECT_LT((frame.totals.angular_momentum - before.angular_momentum).norm(), 1e-6 * before.angular_momentum.norm());
    EXPECT_LT(std::abs(frame.energy.unaccounted()), 1e-3 * before.kinetic_energy);
    EXPECT_NEAR(frame.totals.kinetic_energy + frame.totals.elastic_energy, before.kinetic_energy,
                1e-3 * before.kinetic_energy);
  }
}

/// Largest deviation of the stress at any corner from a uniform one, over that.
double deviation_from(const Frame& frame, const Mat3& stress) {
  double largest = 0;
  for (const QuadraticState& state : frame.elements.quadratic_states)
    for (const ElementState& corner : state.corners)
      largest = std::max(largest, (cauchy_stress(corner.frame, corner.stress) - stress).norm() / stress.norm());
  return largest;
}

TEST(QuadraticLoads, TractionsAndPressuresGiveUniformStress) {
  for (const BoxPattern pattern : {BoxPattern::five_tet, BoxPattern::kuhn, BoxPattern::bcc}) {
    Scene scene = strip_scene({pattern, 1});
    scene.bodies[0].supports.clear();
    Scene squeezed = scene;
    for (const double side : {-1.0, 1.0}) {
      Load pull = tip_load({pattern, 1}, 0);
      pull.region = end_of({pattern, 1}, side);
      pull.traction = Vec3(side * 1e6, 0, 0);
      scene.bodies[0].loads.push_back(pull);
    }
    World pulled(scene);
    pulled.step();
    EXPECT_LT(deviation_from(pulled.frame(), Vec3(1e6, 0, 0).asDiagonal()), 1e-4);
    Load pressure;
    pressure.kind = LoadKind::pressure;
    pressure.region = HalfSpaceRegion{Vec3(-10, 0, 0), Vec3(1, 0, 0)};
    pressure.pressure = 1e6;
    squeezed.bodies[0].loads = {pressure};
    World pressed(squeezed);
    pressed.step();
    EXPECT_LT(deviation_from(pressed.frame(), -1e6 * Mat3::Identity()), 1e-4);
  }
}

}  // namespace
}  // namespace griffith::testing
