// What swings on its supports recoils from bodies in explicit dynamics.

#include <gtest/gtest.h>

#include "sim/world/world.h"

namespace griffith {
namespace {

/// A tet with a corner at the origin.
TetSoup one_tet() {
  TetSoup soup;
  soup.points = {Vec3::Zero(), Vec3(0.4, 0, 0), Vec3(0, 0.3, 0), Vec3(0, 0, 0.3)};
  soup.tets = {{0, 1, 2, 3}};
  return soup;
}

/// A tet on a ball joint at the origin, in weightless space. A ball of this speed strikes a bar that lies on its far
/// end.
Scene struck_pendulum(double speed) {
  Scene scene;
  scene.gravity.setZero();
  scene.ground.reset();
  scene.simulation.time_step = 1e-3;
  BodyDescription& tet = scene.bodies.emplace_back();
  tet.name = "tet";
  tet.shape = MeshFileShape{"tet"};
  tet.supports = {{.region = BoxRegion{Vec3::Constant(-0.01), Vec3::Constant(0.01)}, .can_tear = false}};
  tet.material.stiffness_damping = 0;
  BodyDescription& bar = scene.bodies.emplace_back();
  bar.name = "bar";
  bar.shape = BoxShape{Vec3(0.1, 0.6, 0.1), Vec3::Constant(0.1), BoxPattern::five_tet};
  bar.elements = ElementOrder::linear;
  bar.position = Vec3(0.3, 0.3 + 0.085, 0.02);
  for (BodyDescription& body : scene.bodies) {
    body.material = *find_material_preset("concrete");
    body.material.fracture_toughness *= 10;
  }
  ProjectileBurst& ball = scene.projectiles.emplace_back();
  ball.position = bar.position + Vec3(0, 0.36, 0);
  ball.direction = -Vec3::UnitY();
  ball.speed = speed;
  ball.mass = 5;
  ball.radius = 0.05;
  return scene;
}

TEST(SwingingObstacle, TakesTheAngularMomentumThatTheStrikerLoses) {
  for (const double speed : {2.0, 10.0}) {
    World world(struck_pendulum(speed), InMemoryMeshes{{"tet", one_tet()}});
    world.step();
    const Vec3 start = world.frame().totals.angular_momentum;
    int microsteps = 0;
    for (int i = 0; i < 60; ++i) {
      world.step();
      microsteps += world.frame().report.microsteps;
      const Frame frame = world.frame();
      EXPECT_LT((frame.totals.angular_momentum - start).norm(), 0.02 * start.norm()) << "step " << i;
      EXPECT_LT(std::abs(frame.energy.unaccounted()), 0.01 * frame.energy.turned_over()) << "step " << i;
      EXPECT_LE(frame.energy.stored(), 1.001 * frame.energy.put_in()) << "step " << i;
    }
    EXPECT_GT(microsteps, 0) << "the bar is followed in explicit dynamics";
    EXPECT_GT(world.frame().bodies[0].angular_velocity.norm(), 0.5 * speed) << "the tet swings away";
  }
}

}  // namespace
}  // namespace griffith
