// What falls, flies and strikes keeps its energy: nothing gains any.

#include <gtest/gtest.h>

#include "sim/core/parallel.h"
#include "sim/scene/scene_reader.h"
#include "tests/world/contact/contact_case.h"
#include "tests/world/contact/contact_scenes.h"

namespace griffith {
namespace {

using testing::box;
using testing::ContactCase;
using testing::preset;

class FlightLaw : public testing::ContactLaw<ContactCase> {};

TEST_P(FlightLaw, WhatFallsWithoutSpinDoesNotTurn) {
  const ContactCase& at = GetParam();
  const Shape shapes[] = {
      Shape(BoxShape{Vec3::Constant(at.size), Vec3::Constant(at.size / 4 / at.refinement), BoxPattern::five_tet}),
      Shape(SphereShape{at.size / 2, at.size / 4 / at.refinement})};
  for (const char* material : {"concrete", "jelly"})
    for (const Shape& shape : shapes) {
      Scene scene = testing::empty_scene(at);
      scene.ground.reset();
      BodyDescription& body = scene.bodies.emplace_back();
      body.shape = shape;
      body.material = preset(material);
      body.rotation_degrees = Vec3(10, 20, 30);
      body.velocity = Vec3(1, 2, 3);
      World world(scene);
      const std::vector<Vec3> start = testing::positions_of(world.frame());
      testing::run_to(world, 1);
      const Frame frame = world.frame();
      double turned = 0;
      for (std::size_t node = 0; node < start.size(); ++node)
        turned =
            std::max(turned, (frame.nodes.positions[node] - start[node] - frame.nodes.positions[0] + start[0]).norm());
      testing::check_at_most(std::string(shape.index() ? "ball" : "cube") + " of " + material + " turned by [m]",
                             turned, 1e-6 * at.size);
    }
}

/// Pieces of centimeters at the scale of 0.05 m, which spin at hundreds of radians per second there.
TEST_P(FlightLaw, DebrisThatSpinsKeepsItsEnergyAndAngularMomentum) {
  const ContactCase& at = GetParam();
  const Vec3 sizes[] = {Vec3(0.4, 0.4, 0.4), Vec3(1, 0.2, 0.2), Vec3(1, 1, 0.1), Vec3(0.4, 0.6, 1)};
  int index = 0;
  for (const Vec3& size : sizes) {
    Scene scene = testing::empty_scene(at);
    scene.ground.reset();
    scene.gravity.setZero();
    scene.bodies = {box("piece", at.size * size, Vec3::Zero(), testing::unbreakable(preset("brick")),
                        at.size / at.refinement * size.cwiseMin(0.2))};
    scene.bodies[0].angular_velocity = Vec3(200, 1, 30) * 0.05 / at.size;
    scene.bodies[0].velocity = Vec3(5, 1, 0);
    World world(scene);
    const double energy = world.frame().totals.kinetic_energy, momentum = world.frame().totals.angular_momentum.norm();
    testing::run_to(world, 1);
    const Totals after = world.frame().totals;
    const std::string name = " of shape " + std::to_string(index++);
    testing::check_near("energy" + name + " [J]", after.kinetic_energy + after.elastic_energy, energy, 0.01);
    testing::check_near("angular momentum" + name, after.angular_momentum.norm(), momentum, 0.01);
  }
}

INSTANTIATE_TEST_SUITE_P(Grid, FlightLaw, ::testing::ValuesIn(testing::contact_cases({0.01, 0.05, 1, 10})),
                         testing::contact_case_name);

class LandingLaw : public testing::ContactLaw<ContactCase> {};

/// Returns the deepest that a node gets below the ground in any step within `duration` [s] [m].
double deepest_below_ground(World& world, double duration) {
  double depth = 0;
  while (world.frame().time < duration) {
    world.step();
    depth = std::max(depth, testing::depth_below(world.frame()));
  }
  return depth;
}

/// It falls by many of its sizes within a step, not fast enough to break.
TEST_P(LandingLaw, WhatTakesNoDamageStopsOnTheGround) {
  const ContactCase& at = GetParam();
  Scene scene = testing::empty_scene(at);
  scene.bodies = {box("brick", Vec3::Constant(at.size), Vec3(0, 0.7 * at.size + 0.1, 0), preset("granite"),
                      Vec3::Constant(at.size / at.refinement))};
  scene.bodies[0].velocity = Vec3(0, -0.7, 0);
  World world(scene);
  testing::check_at_most("depth below the ground [sizes]", deepest_below_ground(world, 0.5) / at.size, 0.03);
}

/// A step ends with the velocity that gravity has made: what has hardly begun to fall, or still rises, comes down by up
/// to g dt² in it.
TEST_P(LandingLaw, WhatTurnsBackAboveTheGroundStopsOnIt) {
  const ContactCase& at = GetParam();
  const double gained = testing::kEarthGravity * at.time_step;
  for (const double rising : {0.0, 0.3, 0.6}) {
    Scene scene = testing::empty_scene(at);
    const double gap = (1 - rising) * 0.4 * gained * at.time_step;
    scene.bodies = {box("brick", Vec3::Constant(at.size), Vec3(0, at.size / 2 + gap, 0), preset("granite"),
                        Vec3::Constant(at.size / at.refinement))};
    scene.bodies[0].velocity = Vec3(0, rising * gained, 0);
    World world(scene);
    testing::check_at_most("depth below the ground [sizes], rising at " + testing::short_text(rising) + " g dt",
                           deepest_below_ground(world, 5 * at.time_step) / at.size, 0.03);
  }
}

/// A rod that rests on a held block in its middle; what falls on its end takes that to the ground within a step.
Scene rod_struck_at_its_end(const ContactCase& at) {
  const double size = at.size, thickness = 0.06 * size, cube = 0.25 * size;
  Scene scene = testing::empty_scene(at);
  const Material material = testing::unbreakable(preset("granite"));
  Material heavy = material;
  heavy.density *= 20;
  const Vec3 block = Vec3(0.1, 0.2, 0.2) * size;
  scene.bodies = {box("block", block, Vec3(0, block.y() / 2, 0), material, block / at.refinement),
                  box("rod", Vec3(size, thickness, thickness), Vec3(0, block.y() + thickness / 2, 0), material,
                      Vec3(0.25 * size / at.refinement, thickness, thickness)),
                  box("cube", Vec3::Constant(cube), Vec3(0.4 * size, block.y() + thickness + 0.55 * cube, 0), heavy,
                      Vec3::Constant(cube / at.refinement))};
  scene.bodies[0].supports = {{.region = HalfSpaceRegion{Vec3(0, -size, 0), Vec3::UnitY()}, .can_tear = false}};
  scene.bodies[2].velocity = Vec3(0, -0.5 * size / at.time_step, 0);
  return scene;
}

TEST_P(LandingLaw, ARodStruckAtItsEndDoesNotSwingIntoTheGround) {
  const ContactCase& at = GetParam();
  World world(rod_struck_at_its_end(at));
  testing::check_at_most("depth below the ground [sizes]", deepest_below_ground(world, 20 * at.time_step) / at.size,
                         0.05);
}

INSTANTIATE_TEST_SUITE_P(Grid, LandingLaw, ::testing::ValuesIn(testing::contact_cases({0.01, 0.1, 1})),
                         testing::contact_case_name);

// Of 1 cm and in long steps its elements are 10⁹ times as stiff as its mass, and the contacts of one step do not
// converge. They carry nevertheless: the cube does not drop by g dt², its own size, through the ground.
TEST(Landing, ContactsThatDoNotConvergeCarry) {
  const ContactCase at{0.01, 1, 1.0 / 30};
  World world(rod_struck_at_its_end(at));
  EXPECT_LT(deepest_below_ground(world, 20 * at.time_step), 0.1 * at.size);
}

class StrikingLaw : public testing::ContactLaw<ContactCase> {};

Scene ball_at_ground(const ContactCase& at, const Material& material, double height, double speed) {
  Scene scene = testing::empty_scene(at);
  BodyDescription& ball = scene.bodies.emplace_back();
  ball.shape = SphereShape{at.size / 2, 0.375 * at.size / at.refinement};
  ball.material = material;
  ball.rotation_degrees = Vec3(60.5, 90, -137);
  ball.position = Vec3(0, at.size / 2 + height, 0);
  ball.velocity = Vec3(0, -speed, 0);
  return scene;
}

/// True for the largest ball on the fine mesh, a fifth of the time of all laws. Other balls have its size, its mesh and
/// its step.
bool repeats_balls(const ContactCase& at) {
  return at.size == 1 && at.refinement == 2 && !testing::all_contact_cases();
}

// Energy is what gravity and the start put in, less what is lost.
TEST_P(StrikingLaw, ASoftBallOfGreenStrainGainsNoEnergy) {
  if (repeats_balls(GetParam())) GTEST_SKIP() << "repeats others";
  const bool is_dear = GetParam().refinement == 2 && GetParam().time_step < 0.01;  // as much as all other laws
  if (is_dear && !testing::all_contact_cases()) GTEST_SKIP() << "its mesh and its step are others'";
  Material soft;
  soft.young_modulus = 64400;
  soft.tensile_strength = 1080;
  soft.element_model = ElementModel::green_strain;
  World world(ball_at_ground(GetParam(), soft, 2 * GetParam().size, 0));
  // Its heap of soft shards, which goes on for seconds, costs most: .1 s of it are enough.
  testing::check_energy(world, 0.1 + std::sqrt(4 * GetParam().size / 9.81));
}

Material brick_of(ElementModel model) {
  Material brick = preset("brick");
  brick.element_model = model;
  return brick;
}

TEST_P(StrikingLaw, ADroppedBrickBallGainsNoEnergy) {
  World world(ball_at_ground(GetParam(), brick_of(ElementModel::corotational), GetParam().size, 0));
  testing::check_energy(world, 0.5 + std::sqrt(GetParam().size));
}

TEST_P(StrikingLaw, ADroppedBrickBallOfGreenStrainGainsNoEnergy) {
  World world(ball_at_ground(GetParam(), brick_of(ElementModel::green_strain), GetParam().size, 0));
  testing::check_energy(world, 0.5 + std::sqrt(GetParam().size));
}

TEST_P(StrikingLaw, AThrownBrickBallOfGreenStrainGainsNoEnergy) {
  World world(ball_at_ground(GetParam(), brick_of(ElementModel::green_strain), GetParam().size, 10));
  testing::check_energy(world, 0.5 + GetParam().size / 10);
}

TEST_P(StrikingLaw, AThrownBrickBallGainsNoEnergy) {
  World world(ball_at_ground(GetParam(), brick_of(ElementModel::corotational), GetParam().size, 10));
  testing::check_energy(world, 0.5 + GetParam().size / 10);
}

/// A cylinder of weak, layered brick that comes down in splinters on a held beam with a notch, and three slow shots.
Scene splinters_on_beam(const ContactCase& at) {
  Scene scene = testing::empty_scene(at);
  scene.ground = Ground{.height = 0, .friction = 0, .restitution = 0.5};
  scene.simulation.relative_residual = 0.01;
  scene.simulation.step_budget = 1;
  const double size = at.size;
  BodyDescription& beam = scene.bodies.emplace_back();
  beam.name = "beam";
  beam.shape = NotchedBeamShape{size * Vec3(1, 0.3, 0.2), 0.1 * size, Vec3::Constant(0.2 * size / at.refinement)};
  beam.position = Vec3(0, 0.6 * size, 0);
  beam.material.young_modulus = 2.92e9;
  beam.material.fracture_toughness = 316;
  beam.supports = {{.region = HalfSpaceRegion{Vec3(0, -0.05 * size, 0), -Vec3::UnitY()}, .can_tear = false}};
  BodyDescription& cylinder = scene.bodies.emplace_back();
  cylinder.name = "cylinder";
  cylinder.shape = CylinderShape{0.3 * size, size, Vec2::Constant(0.3 * size / at.refinement)};
  cylinder.position = Vec3(0, 1.8 * size, 0);
  cylinder.material.stiffness_damping = 0;
  cylinder.splinters = RadialSplinters{.sectors = 4, .first_ring = 0.2 * size};
  cylinder.collision = CollisionShape::splinters;
  cylinder.weakness = Weakness{WeaknessKind::layers, Vec3(-0.0505, -0.005, -0.47), 0.01};
  ProjectileBurst& shots = scene.projectiles.emplace_back();
  shots = {.count = 3, .interval = 0.05, .position = size * Vec3(0, 0.6, 2), .direction = Vec3(-0.0211, 0.0318, -1)};
  shots.speed = 0.364;
  shots.mass = 42.3;
  shots.radius = 0.05 * size;
  return scene;
}

TEST_P(StrikingLaw, SplintersOnANotchedBeamGainNoEnergy) {
  World world(splinters_on_beam(GetParam()));
  testing::check_energy(world, 5.0 / 3);
}

/// Outcome of some steps.
struct StepsMade {
  std::uint64_t state;
  int undone;  ///< substeps whose microsteps exceeded their share of the work
};

StepsMade make_two_steps(World world, int threads) {
  const ThreadLimit limit(threads);
  int undone = 0;
  for (int step = 0; step < 2; ++step)
    world.step({.wants = [](std::int64_t) { return false; }, .take = {}, .undo = [&](std::int64_t) { ++undone; }});
  return {world.state_hash(), undone};
}

/// The pane dices in the fourth step, which takes more work than a small budget foresees.
TEST(RepeatedStep, HasTheSameBitsForAnyNumberOfThreads) {
  Scene scene = read_scene(GRIFFITH_SOURCE_DIR "/scenes/tempered_pane.json");
  scene.simulation.step_budget = 2;
  World world(scene);
  for (int step = 0; step < 3; ++step) world.step();
  const StepsMade alone = make_two_steps(world, 1);
  EXPECT_GT(alone.undone, 0);
  for (const int threads : {2, 4}) EXPECT_EQ(make_two_steps(world, threads).state, alone.state) << threads;
}

INSTANTIATE_TEST_SUITE_P(Grid, StrikingLaw, ::testing::ValuesIn(testing::contact_cases({0.272, 0.557, 1})),
                         testing::contact_case_name);

}  // namespace
}  // namespace griffith
