#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "sim/geometry/disjoint_sets.h"
#include "sim/world/world.h"
#include "tests/world/fracture/crack_area.h"

namespace griffith {
namespace {

/// A free plate of concrete, and balls that strike it one after the other, 50 ms apart, without gravity.
Scene struck_plate(double time_step, std::initializer_list<double> speeds) {
  Scene scene;
  scene.gravity.setZero();
  scene.ground.reset();
  scene.simulation.time_step = time_step;
  scene.simulation.step_budget = 1000;
  BodyDescription& plate = scene.bodies.emplace_back();
  plate.material = *find_material_preset("concrete");
  plate.shape = BoxShape{Vec3(1, 1, 0.1), Vec3(0.125, 0.125, 0.05), BoxPattern::five_tet};
  for (const double speed : speeds) {
    ProjectileBurst& ball = scene.projectiles.emplace_back();
    ball.start = 0.05 * static_cast<double>(scene.projectiles.size() - 1);
    ball.position = Vec3(0.03, 0.05, 0.16);
    ball.direction = -Vec3::UnitZ();
    ball.speed = speed;
    ball.mass = 5;
    ball.radius = 0.08;
  }
  return scene;
}

/// Returns, per tet, the smallest index of those that faces connect it with.
std::vector<int> parts_of(const Frame& frame) {
  std::vector<std::pair<int, int>> links;
  for (int tet = 0; tet < static_cast<int>(frame.elements.tets.size()); ++tet)
    for (const TetId other : frame.elements.neighbors[TetId(tet)])
      if (other.valid()) links.emplace_back(tet, static_cast<int>(other.index()));
  return connected_groups(static_cast<int>(frame.elements.tets.size()), links);
}

std::size_t number_of_parts(const Frame& frame) {
  const std::vector<int> parts = parts_of(frame);
  std::size_t count = 0;
  for (std::size_t i = 0; i < parts.size(); ++i) count += parts[i] == static_cast<int>(i);
  return count;
}

void run(World& world, double duration) {
  for (const double end = world.frame().time + duration - 1e-9; world.frame().time < end;) world.step();
}

TEST(BondedPieces, PartsThatBondsHoldMoveAsOneBody) {
  World world(struck_plate(1.0 / 240, {9}));
  run(world, 0.05);
  const std::vector<BodyId> bodies(world.frame().elements.bodies.begin(), world.frame().elements.bodies.end());
  ASSERT_GT(number_of_parts(world.frame()), 2 * world.frame().bodies.size());
  const auto distances = [&] {
    const Frame frame = world.frame();
    std::vector<double> all;
    for (std::size_t tet = 1; tet < frame.elements.tets.size(); ++tet) {
      const TetId a(static_cast<std::int64_t>(tet - 1)), b(static_cast<std::int64_t>(tet));
      if (bodies[tet - 1] != bodies[tet]) continue;
      all.push_back(
          (frame.nodes.positions[frame.elements.tets[a][0]] - frame.nodes.positions[frame.elements.tets[b][0]]).norm());
    }
    return all;
  };
  const std::vector<double> before = distances();
  run(world, 0.05);
  EXPECT_TRUE(std::ranges::equal(bodies, world.frame().elements.bodies));
  const std::vector<double> after = distances();
  for (std::size_t i = 0; i < before.size(); ++i) EXPECT_NEAR(after[i], before[i], 1e-5);
}

TEST(BondedPieces, AreNoNewBodiesWhenTheyAreTouchedAndBreakWhenTheyAreHit) {
  World touched(struck_plate(1.0 / 240, {6, 0.1})), hit(struck_plate(1.0 / 240, {6, 30}));
  run(touched, 0.04);
  const std::size_t bodies = touched.frame().bodies.size();
  for (World* world : {&touched, &hit}) run(*world, 0.1);
  EXPECT_EQ(touched.frame().bodies.size(), bodies);
  EXPECT_GT(hit.frame().bodies.size(), 4 * bodies);
}

TEST(BondedPieces, WhatBreaksOfAQuadraticPlateDoesNotDependOnTheTimeStep) {
  struct QuadraticDamage {
    double bodies = 0, opened = 0, taken = 0;
  };
  const auto damage_in = [](double time_step) {
    Scene scene = struck_plate(time_step, {15});
    scene.bodies[0].elements = ElementOrder::quadratic;
    World world(scene);
    run(world, 0.02);
    return QuadraticDamage{static_cast<double>(world.frame().bodies.size()), testing::crack_area(world.frame()),
                           world.frame().energy.fracture};
  };
  const QuadraticDamage usual = damage_in(1.0 / 60);
  for (const double time_step : {1.0 / 250, 1.0 / 1000, 1.0 / 2000}) {
    const QuadraticDamage damage = damage_in(time_step);
    EXPECT_NEAR(damage.bodies, usual.bodies, 0.35 * usual.bodies) << time_step;
    EXPECT_NEAR(damage.opened, usual.opened, 0.15 * usual.opened) << time_step;
    EXPECT_NEAR(damage.taken, usual.taken, 0.15 * usual.taken) << time_step;
  }
}

}  // namespace
}  // namespace griffith
