#include "app/editor/shooting.h"

#include <gtest/gtest.h>

#include <random>

#include "program.h"
#include "sim/world/world.h"

namespace griffith::app {
namespace {

TEST(Shooting, TheParabolaGoesThroughTheTarget) {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> place(-8, 8);
  const auto point = [&] { return Vec3(place(random), place(random), place(random)); };
  for (int i = 0; i < 500; ++i) {
    const Vec3 muzzle = point(), target = point(), gravity = i % 5 == 0 ? Vec3::Zero() : Vec3(0, -9.81, 0);
    ProjectileBurst shot;
    shot.speed = 40;
    const ProjectileBurst aimed = aimed_shot(shot, muzzle, target, gravity);
    EXPECT_NEAR(aimed.direction.norm(), 1, 1e-12);
    EXPECT_EQ(aimed.position, muzzle);
    double nearest = 1e9;
    for (double t = 0; t < 1; t += 1e-4) {
      nearest = std::min(nearest, (muzzle + t * 40 * aimed.direction + t * t / 2 * gravity - target).norm());
    }
    EXPECT_LT(nearest, 0.01);
  }
}

TEST(Shooting, WhatIsOutOfReachIsShotAtStraight) {
  ProjectileBurst shot;
  shot.speed = 1;
  const ProjectileBurst aimed = aimed_shot(shot, Vec3::Zero(), Vec3(100, 0, 0), Vec3(0, -9.81, 0));
  EXPECT_LT((aimed.direction - Vec3::UnitX()).norm(), 1e-12);
  EXPECT_NEAR(aimed_shot(shot, Vec3::Zero(), Vec3::Zero(), Vec3::Zero()).direction.norm(), 1, 1e-12);
}

TEST(Shooting, RaysHitTheNearSideThenTheGroundThenNothing) {
  Scene unloaded = small_wall();
  unloaded.simulation.static_start = false;  // the wall's weight would move its face by a hair
  const World world(unloaded);
  const Frame frame = world.frame();
  const Ground ground;
  const auto front = surface_hit(frame, ground, Vec3(0.1, 1.1, 5), -Vec3::UnitZ());
  ASSERT_TRUE(front);
  EXPECT_NEAR(*front, 4.75, 1e-9);
  const auto floor = surface_hit(frame, ground, Vec3(5, 3, 5), -Vec3::UnitY());
  ASSERT_TRUE(floor);
  EXPECT_NEAR(*floor, 3, 1e-9);
  EXPECT_FALSE(surface_hit(frame, ground, Vec3(5, 3, 5), Vec3::UnitY()));
  EXPECT_FALSE(surface_hit(frame, std::nullopt, Vec3(5, 3, 5), -Vec3::UnitY()));
}

TEST(Shooting, TheForetoldFlightEndsWhereTheShotHits) {
  Scene scene = small_wall();
  scene.simulation.static_start = false;
  scene.projectiles.clear();
  World world(scene);
  ProjectileBurst shot;
  shot.speed = 12;
  shot.radius = 0.02;
  shot.mass = 0.01;
  const Vec3 target(0.1, 1.1, 0.25);
  shot = aimed_shot(shot, Vec3(0.4, 0.8, 6), target, scene.gravity);
  const ui::Aim aim = flight_of(shot, target, scene.gravity, world.frame(), scene.ground);
  ASSERT_TRUE(aim.hits);
  EXPECT_LT((aim.flight.back() - target).norm(), 2e-3) << "as chords of an arc have it";
  shot = world.fire(shot);
  double nearest = 1e9, when = 0;
  for (int i = 0; i < 120; ++i) {
    world.step();
    const double away = (world.frame().projectiles.back().position - target).norm();
    if (away < nearest) nearest = away, when = world.frame().time;
  }
  EXPECT_LT(nearest, 0.1);
  EXPECT_NEAR(when, aim.duration, 2 * scene.simulation.time_step);
}

TEST(Shooting, AHighArcIsStoppedByWhatStandsInItsWay) {
  const World world(small_wall());
  ProjectileBurst shot;
  shot.speed = 9;
  const Vec3 behind(0, 0.5, -3);
  shot = aimed_shot(shot, Vec3(0, 0.5, 3), behind, Vec3(0, -9.81, 0));
  const ui::Aim aim = flight_of(shot, behind, Vec3(0, -9.81, 0), world.frame(), Ground{});
  ASSERT_TRUE(aim.hits);
  EXPECT_GT(aim.flight.back().z(), 0) << "at the wall's near side";
  EXPECT_FALSE(flight_of(shot, behind, Vec3::Zero(), Frame{}, std::nullopt).hits);
}

}  // namespace
}  // namespace griffith::app
