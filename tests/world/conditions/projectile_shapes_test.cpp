#include <gtest/gtest.h>

#include <fstream>

#include "sim/core/error.h"
#include "sim/scene/scene_reader.h"
#include "sim/world/world.h"

namespace griffith {
namespace {

/// Strong plates that nothing breaks, 0.1 m thick, in weightless space; one substep a step.
Scene plate_scene(bool held) {
  Scene scene;
  scene.gravity.setZero();
  scene.ground.reset();
  BodyDescription plate;
  plate.shape = BoxShape{Vec3(2, 2, 0.1), Vec3(0.5, 0.5, 0.1), BoxPattern::five_tet};
  plate.material.tensile_strength = plate.material.fracture_toughness = 1e13;
  if (held) plate.supports = {{HalfSpaceRegion{Vec3(0, -0.9, 0), -Vec3::UnitY()}}};
  scene.bodies = {plate};
  scene.simulation.impact_substeps = 1;
  return scene;
}

std::vector<std::optional<ProjectileShape>> shapes() {
  const std::vector<Vec3> octahedron = {{.15, 0, 0}, {-.15, 0, 0}, {0, .1, 0}, {0, -.1, 0}, {0, 0, .2}, {0, 0, -.2}};
  return {std::nullopt, BoxProjectile{Vec3(0.05, 0.4, 0.1)}, PointsProjectile{octahedron}};
}

TEST(ProjectileShapes, FastOnesStayOnTheirSideOfAPlate) {
  for (bool held : {true, false})
    for (const auto& shape : shapes())
      for (int turned = 0; turned < 4; ++turned) {
        Scene scene = plate_scene(held);
        ProjectileBurst shot;
        shot.position = Vec3(0.1, 0.2, 1.3);
        shot.speed = 100;
        shot.mass = 2;
        shot.radius = 0.05;
        shot.shape = shape;
        shot.rotation_degrees = 35.0 * turned * Vec3(1, 0.4, 0.7);
        shot.angular_velocity = 10.0 * turned * Vec3(1, -1, 0.5);
        scene.projectiles = {shot};
        World world(scene);
        double height = 0;
        for (int step = 0; step < 12; ++step) {
          world.step();
          const Frame frame = world.frame();
          const BodyView& plate = frame.bodies[0];
          height =
              plate.orientation.conjugate().operator*(Vec3(frame.projectiles[0].position - plate.center_of_mass)).z();
          EXPECT_GT(height, 0) << "held " << held << ", turned " << turned << ", step " << step;
        }
        EXPECT_LT(height, 1.2) << "it has met the plate";
      }
}

TEST(ProjectileShapes, FastPiecesStayOnTheirSideOfAPlate) {
  for (int turned = 0; turned < 6; ++turned) {
    Scene scene = plate_scene(true);
    BodyDescription piece;
    piece.name = "piece";
    piece.shape = BoxShape{Vec3(0.1, 0.2, 0.15), Vec3::Constant(1), BoxPattern::five_tet};
    piece.material = scene.bodies[0].material;
    piece.position = Vec3(0.1, 0.2, 4);
    piece.rotation_degrees = 25.0 * turned * Vec3(1, 0.4, 0.7);
    scene.bodies.push_back(piece);
    World resting(scene);
    for (int step = 0; step < 30; ++step) resting.step();
    ASSERT_TRUE(resting.frame().bodies[1].rigid) << "it is debris by now: rigid";
    scene.bodies[1].velocity = Vec3(0, 0, -100.0 / 10);
    scene.bodies[1].position.z() = 3.6;  // ten times slower: rigid before it strikes
    World slow(scene);
    for (int step = 0; step < 60; ++step) slow.step();
    EXPECT_GT(slow.frame().bodies[1].center_of_mass.z(), 0) << turned;
    scene.bodies[1].velocity = Vec3(0, 0, -100);
    scene.bodies[1].position.z() = 22;
    World fast(scene);
    for (int step = 0; step < 40; ++step) fast.step();
    EXPECT_GT(fast.frame().bodies[1].center_of_mass.z(), 0) << turned;
  }
}

TEST(ProjectileShapes, MomentumIsKeptWhateverStrikes) {
  for (const auto& shape : shapes()) {
    Scene scene = plate_scene(false);
    ProjectileBurst shot;
    shot.position = Vec3(0.2, 0.3, 1);
    shot.speed = 30;
    shot.density = 1500;
    shot.shape = shape;
    shot.angular_velocity = Vec3(2, 3, 4);
    scene.projectiles = {shot};
    World world(scene);
    world.step();
    const Totals before = world.frame().totals;
    for (int step = 0; step < 20; ++step) world.step();
    const Totals after = world.frame().totals;
    EXPECT_GT(world.frame().bodies[0].velocity.norm(), 0.1);
    EXPECT_LT((after.momentum - before.momentum).norm(), 1e-6 * before.momentum.norm());
    EXPECT_LT((after.angular_momentum - before.angular_momentum).norm(), 0.01 * before.angular_momentum.norm());
  }
}

TEST(ProjectileShapes, DensityAndHullSayTheMass) {
  Scene scene = plate_scene(false);
  ProjectileBurst shot;
  shot.density = 2000;
  shot.shape = BoxProjectile{Vec3(0.1, 0.2, 0.3)};
  scene.projectiles = {shot};
  World world(scene);
  world.step();
  EXPECT_NEAR(world.frame().projectiles[0].mass, 2000 * 0.006, 1e-9);
  EXPECT_EQ(world.frame().projectiles[0].corners.size(), 8u);
}

TEST(ProjectileShapes, BadOnesAreNamed) {
  const auto message = [](const std::string& burst) {
    try {
      World world(scene_from_json(R"({"version": 1, "projectiles": [)" + burst + "]}", "doc"));
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  const auto contains = [](const std::string& text, const std::string& part) {
    EXPECT_NE(text.find(part), std::string::npos) << text << " lacks " << part;
  };
  contains(message(R"({"shape": {"points": [[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0]]}})"),
           "doc#/projectiles/0/shape/points: span no volume");
  contains(message(R"({"shape": {"points": [[0, 0]]}})"), "doc#/projectiles/0/shape/points/0");
  contains(message(R"({"shape": {"surface": {"path": "nothing.obj"}}})"), "doc#/projectiles/0/shape/surface/path");
  contains(message(R"({"shape": {"cone": {}}})"), "doc#/projectiles/0/shape");
  contains(message(R"({"density": 3, "mass": 2})"), "doc#/projectiles/0/density: is set together with a mass");
  contains(message(R"({"radius": 3, "shape": {"box": {}}})"),
           "doc#/projectiles/0/radius: is set together with a shape");
  EXPECT_EQ(message(R"({"density": 3, "shape": {"box": {"size": [1, 2, 3]}}})"), "");
}

}  // namespace
}  // namespace griffith
