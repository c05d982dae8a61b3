#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

#include "sim/world/bodies/bodies.h"
#include "sim/world/setup/build_world.h"
#include "sim/world/state/world_state.h"
#include "sim/world/world.h"
#include "tests/world/scenes.h"

namespace griffith {
namespace {

using testing::brick;

BodyDescription block(const std::string& name, const Vec3& size, const Vec3& position) {
  BodyDescription body;
  body.name = name;
  body.shape = BoxShape{size, size, BoxPattern::five_tet};
  body.position = position;
  body.material = brick(1);
  return body;
}

Scene stack_of_blocks(int count) {
  Scene scene;
  for (int i = 0; i < count; ++i)
    scene.bodies.push_back(block("block " + std::to_string(i), Vec3(0.4, 0.2, 0.3), Vec3(0, 0.1 + 0.2 * i, 0)));
  return scene;
}

/// Steps on; the largest distance that a node has moved.
double creep(World& world, int steps) {
  const std::vector<Vec3> before(world.frame().nodes.positions.begin(), world.frame().nodes.positions.end());
  for (int step = 0; step < steps; ++step) world.step();
  double moved = 0;
  for (std::size_t i = 0; i < before.size(); ++i)
    moved = std::max(moved, (before[i] - world.frame().nodes.positions[i]).norm());
  return moved;
}

TEST(Rest, AStackOfTenBrittleBlocksStandsAndSleeps) {
  World world(stack_of_blocks(10));
  EXPECT_LT(creep(world, 240), 1e-3);
  EXPECT_EQ(world.frame().report.sleeping_bodies, 10);
  EXPECT_EQ(creep(world, 7200), 0);
  EXPECT_EQ(world.frame().bodies.size(), 10u);
}

/// Blocks that fall onto each other from up to 2.5 m, and break.
Scene heap_of_blocks(unsigned seed) {
  Scene scene;
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (int i = 0; i < 40; ++i) {
    scene.bodies.push_back(block("block " + std::to_string(i), Vec3(0.1, 0.08, 0.12),
                                 Vec3(0.15 * uniform(random), 0.2 + 0.12 * i / 2.0, 0.15 * uniform(random))));
    scene.bodies.back().rotation_degrees = 90 * Vec3(uniform(random), uniform(random), uniform(random));
  }
  return scene;
}

TEST(Rest, HeapsOfBlocksSleepAndDoNotCreep) {
  std::vector<int> steps;
  for (unsigned seed = 1; seed <= 4; ++seed) {
    World world(heap_of_blocks(seed));
    const auto all_sleep = [&] {
      return world.frame().report.sleeping_bodies == static_cast<int>(world.frame().bodies.size());
    };
    while (!all_sleep() && world.frame().step < 2400) {
      world.step();
      // Pieces that get into one another: what holds them from two sides must not press them ever tighter.
      EXPECT_GT(world.frame().energy_of_step.contacts, -2) << "heap " << seed << ", step " << world.frame().step;
    }
    EXPECT_TRUE(all_sleep()) << "heap " << seed;
    steps.push_back(static_cast<int>(world.frame().step));
    EXPECT_EQ(creep(world, 600), 0);
  }
  std::ranges::sort(steps);
  EXPECT_LT(steps[1], 780) << "most sleep within some five seconds";
}

TEST(Rest, WhereAllSleepsAStepMovesTimeAlone) {
  World world(stack_of_blocks(3));
  for (int step = 0; step < 240; ++step) world.step();
  ASSERT_EQ(world.frame().report.sleeping_bodies, 3);
  const StateHashes before = world.state_hashes();
  const double time = world.frame().time, energy = world.frame().energy.lost();
  for (int step = 0; step < 12; ++step) world.step();
  EXPECT_EQ(world.state_hashes(), before);
  EXPECT_NEAR(world.frame().time - time, 12 * world.scene().simulation.time_step, 1e-12);
  EXPECT_EQ(world.frame().energy.lost(), energy);
  EXPECT_EQ(world.frame().report.sleeping_bodies, 3);
}

std::size_t body_of_node(const Frame& frame, std::size_t node) {
  return static_cast<std::size_t>(frame.elements.bodies[frame.nodes.stars[node].front()].index());
}

Vec3 center_by_nodes(const Frame& frame, int body) {
  Vec3 moment = Vec3::Zero();
  double mass = 0;
  for (std::size_t i = 0; i < frame.nodes.positions.size(); ++i) {
    if (body_of_node(frame, i) != static_cast<std::size_t>(body)) continue;
    moment += frame.nodes.masses[i] * frame.nodes.positions[i];
    mass += frame.nodes.masses[i];
  }
  return moment / mass;
}

TEST(Rest, AShotWakesWhatItHits) {
  World world(stack_of_blocks(3));
  for (int step = 0; step < 240; ++step) world.step();
  ASSERT_EQ(world.frame().report.sleeping_bodies, 3);
  ProjectileBurst shot;
  shot.position = Vec3(0, 0.3, 0.5);  // near, so that it hits before it falls
  shot.speed = 10;
  shot.mass = 5;
  shot.radius = 0.05;
  world.fire(shot);
  for (int step = 0; step < 60; ++step) {
    world.step();
    for (int body = 0; body < 3; ++body)
      EXPECT_LT((world.frame().bodies[body].center_of_mass - center_by_nodes(world.frame(), body)).norm(), 1e-9);
  }
  EXPECT_LT(world.frame().bodies[1].center_of_mass.z(), -2e-3);
}

/// A stack that has fallen asleep, and a brick that flies past.
World sleepers_and_flyer() {
  Scene scene = stack_of_blocks(3);
  scene.bodies.push_back(block("flyer", Vec3(0.4, 0.2, 0.3), Vec3(3, 60, 0)));
  scene.bodies.back().angular_velocity = Vec3(1, 2, 3);
  World world(scene);
  while (world.frame().report.sleeping_bodies < 3 && world.frame().step < 180) world.step();
  return world;
}

TEST(Rest, SleepersStayToTheBitWhileSomethingFliesPast) {
  World world = sleepers_and_flyer();
  ASSERT_EQ(world.frame().report.sleeping_bodies, 3);
  const Frame before = world.frame();
  const std::vector<Vec3> positions(before.nodes.positions.begin(), before.nodes.positions.end());
  const std::vector<BodyView> views(before.bodies.begin(), before.bodies.end());
  for (int step = 0; step < 12; ++step) {
    world.step();
    const Frame frame = world.frame();
    ASSERT_EQ(frame.report.sleeping_bodies, 3);
    EXPECT_NE(frame.bodies[3].center_of_mass, views[3].center_of_mass);
    for (int body = 0; body < 3; ++body) EXPECT_EQ(frame.bodies[body].center_of_mass, views[body].center_of_mass);
    for (std::size_t i = 0; i < positions.size(); ++i)
      EXPECT_EQ(frame.nodes.positions[i] == positions[i], frame.bodies[body_of_node(frame, i)].asleep);
  }
}

TEST(Rest, WhatFliesPastSleepersMovesAsIfTheyWereNotThere) {
  World among = sleepers_and_flyer();
  Scene scene = among.scene();
  scene.bodies.erase(scene.bodies.begin(), scene.bodies.begin() + 3);
  World alone(scene);
  while (alone.frame().step < among.frame().step) alone.step();
  for (int step = 0; step < 12; ++step) {
    among.step();
    alone.step();
    EXPECT_EQ(among.frame().bodies[3].center_of_mass, alone.frame().bodies[0].center_of_mass);
    EXPECT_EQ(among.frame().bodies[3].angular_velocity, alone.frame().bodies[0].angular_velocity);
  }
}

/// A weightless plank, and a ball that strikes it in the middle after `rest` [s].
Scene struck_plank(const Material& material, double rest, double speed) {
  Scene scene;
  scene.gravity.setZero();
  scene.ground.reset();
  BodyDescription plank = block("plank", Vec3(1, 0.2, 0.2), Vec3::Zero());
  plank.shape = BoxShape{Vec3(1, 0.2, 0.2), Vec3::Constant(0.1), BoxPattern::five_tet};
  plank.material = material;
  scene.bodies = {plank};
  ProjectileBurst shot;
  shot.position = Vec3(0.02, 0.01, 0.3);
  shot.speed = speed;
  shot.mass = 20;
  shot.radius = 0.05;
  shot.start = rest;
  scene.projectiles = {shot};
  return scene;
}

bool shot_breaks(const Scene& scene) {
  World world(scene);
  const double end = scene.projectiles[0].start + 0.3 / scene.projectiles[0].speed + 0.1;
  while (world.frame().time < end && world.frame().crack_events.empty()) world.step();
  return !world.frame().crack_events.empty();
}

double breaking_speed(const std::function<Scene(double)>& scene_at) {
  double holds = 0.01, breaking = 300;
  while (breaking > 1.05 * holds) {
    const double middle = std::sqrt(holds * breaking);
    (shot_breaks(scene_at(middle)) ? breaking : holds) = middle;
  }
  return breaking;
}

/// A body at rest is rigid. Any load that would have broken it in short steps must be predicted, and wake it.
TEST(Rest, DoesNotMakeABodyStronger) {
  const Material wood = *find_material_preset("wood_along_grain");
  const auto scene_of = [&](int kind, double rest, double speed) {
    Scene scene = struck_plank(wood, rest, speed);
    BodyDescription& plank = scene.bodies[0];
    if (kind == 0) plank.weakness = Weakness{WeaknessKind::layers, Vec3::UnitX(), 0.03};
    if (kind == 1) plank.strength_scatter = StrengthScatter{1, 1e-5, 6};
    if (kind == 2) plank.material.criterion = FractureCriterion::separation_force;
    if (kind == 2) plank.material.separation_toughness = 1e4;  // as 0.9 MPa on the elements' faces
    return scene;
  };
  for (int kind = 0; kind < 3; ++kind) {
    const double fresh = breaking_speed([&](double speed) {
      Scene scene = scene_of(kind, 0, speed);
      scene.simulation.time_step = 1.0 / 2000;
      return scene;
    });
    EXPECT_TRUE(shot_breaks(scene_of(kind, 0.5, 1.3 * fresh))) << "kind " << kind << " at " << fresh << " m/s";
  }
}

TEST(Rest, TheSpeedThatHurtsIsThatOfTheWeakestPlane) {
  const auto speed_of = [](const Scene& scene) {
    const WorldState world = build_world(scene);
    return damage_speed(world, world.bodies[0]);
  };
  Scene scene = struck_plank(brick(1), 0, 1);
  const double uniform = speed_of(scene);
  EXPECT_NEAR(uniform, 0.5 * 2.5e6 / (1900 * std::sqrt(15e9 / 1900)), 1e-9);
  scene.bodies[0].weakness = Weakness{WeaknessKind::layers, Vec3::UnitY(), 0.2};
  EXPECT_NEAR(speed_of(scene), 0.2 * uniform, 1e-9);
  scene.bodies[0].weakness.reset();
  scene.bodies[0].strength_scatter = StrengthScatter{10, 1e-4, 1};
  const WorldState scattered = build_world(scene);
  const double minimum = *std::ranges::min_element(scattered.nodes.strength_factors);
  EXPECT_NEAR(speed_of(scene), minimum * uniform, 1e-9);
  scene.bodies[0].strength_scatter.reset();
  Material& material = scene.bodies[0].material;
  material.criterion = FractureCriterion::separation_force;
  const double size = std::cbrt(6 * 0.1 * 0.1 * 0.1 / 5);  // five tets a cell
  material.separation_toughness = material.tensile_strength * size * size;
  EXPECT_NEAR(speed_of(scene), uniform, 1e-9);
}

}  // namespace
}  // namespace griffith
