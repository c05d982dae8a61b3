// Pushes by balances: momentum, angular momentum, energy; where they act, how long, and what they wake and break.

#include "sim/world/conditions/push.h"

#include <gtest/gtest.h>

#include <cmath>

#include "sim/core/parallel.h"
#include "sim/world/world.h"
#include "tests/input_error_of.h"
#include "tests/world/held_scenes.h"
#include "tests/world/scenes.h"

namespace griffith::testing {
namespace {

Push push_at(const Frame& frame, const Vec3& place, const Vec3& impulse) {
  const auto [tet, weights] = place_at(frame, place);
  return {tet, weights, impulse};
}

TEST(Push, ItsImpulseIsTheMomentumForAnyTimeStepStiffnessAndIntegrator) {
  const Vec3 impulse(3, -5, 2), arm(0.19, 0.1, -0.05);
  for (const Integrator integrator : {Integrator::implicit, Integrator::hybrid, Integrator::explicit_})
    for (const double young_modulus : {1e6, 1e10})
      for (const double time_step : {1e-3, 1.0 / 60}) {
        Scene scene = floating_block(2, young_modulus);
        scene.simulation.integrator = integrator;
        scene.simulation.time_step = time_step;
        World world(scene);
        world.push(push_at(world.frame(), scene.bodies[0].position + arm, impulse));
        for (int i = 0; i < 5; ++i) {
          world.step();
          ASSERT_LT((world.frame().totals.momentum - impulse).norm(), 1e-9) << young_modulus << " at step " << i;
        }
        const Vec3 spin = (scene.bodies[0].position + arm).cross(impulse);
        EXPECT_LT((world.frame().totals.angular_momentum - spin).norm(), 0.02 * spin.norm())
            << young_modulus << " with " << time_step;
      }
}

TEST(Push, ARigidElementTakesItToo) {
  Scene scene = floating_block();  // of one cell
  scene.bodies[0].shape = BoxShape{Vec3::Constant(0.4), Vec3::Constant(0.4), BoxPattern::kuhn};
  World world(scene);
  const Vec3 impulse(1, 2, 3);
  world.push(push_at(world.frame(), scene.bodies[0].position, impulse));
  world.step();
  EXPECT_LT((world.frame().totals.momentum - impulse).norm(), 1e-9);
}

TEST(Push, SeveralInOneStepAddUp) {
  const Scene scene = floating_block(2);
  World world(scene);
  for (const double x : {-0.1, 0.1}) {
    const Vec3 place = scene.bodies[0].position + Vec3(x, 0, 0);
    world.push(push_at(world.frame(), place, Vec3(0, 0, 4)));
  }
  world.step();
  EXPECT_LT((world.frame().totals.momentum - Vec3(0, 0, 8)).norm(), 1e-9);
}

TEST(Push, ItsWorkIsInTheEnergyAccount) {
  for (const ElementOrder order : {ElementOrder::linear, ElementOrder::quadratic})
    for (const double young_modulus : {1e6, 1e10}) {
      Scene scene = floating_block(2, young_modulus);
      scene.bodies[0].elements = order;
      World world(scene);
      const double mass = world.frame().totals.mass, impulse = 20;
      world.push(push_at(world.frame(), scene.bodies[0].position, Vec3(impulse, 0, 0)));
      for (int i = 0; i < 10; ++i) world.step();
      const EnergyAccount energy = world.frame().energy;
      EXPECT_GE(energy.loads, impulse * impulse / (2 * mass) * (1 - 1e-6)) << "as a point mass, and strain";
      EXPECT_LT(std::abs(energy.unaccounted()), 0.01 * energy.turned_over()) << young_modulus;
    }
}

TEST(Push, WakesAPieceThatComesToRestAgain) {
  World world(stack());
  const auto asleep = [&] { return world.frame().bodies[1].asleep; };
  for (int i = 0; i < 300 && !asleep(); ++i) world.step();
  ASSERT_TRUE(asleep());
  const double before = world.frame().bodies[1].center_of_mass.x();
  world.push(push_at(world.frame(), Vec3(-0.2, 0.6, 0), Vec3(200, 0, 0)));
  world.step();
  EXPECT_FALSE(asleep());
  for (int i = 0; i < 900 && !asleep(); ++i) world.step();
  EXPECT_TRUE(asleep());
  EXPECT_GT(world.frame().bodies[1].center_of_mass.x(), before + 0.01);
}

/// A brick column, its foot held, pushed at its top.
World pushed_column(double impulse) {
  Scene scene;
  scene.simulation.time_step = 1.0 / 60;
  scene.bodies = {wall(Vec3(0.4, 1.6, 0.4), 0.2, brick(0.1))};
  World world(scene);
  world.push(push_at(world.frame(), Vec3(0.2, 1.5, 0), Vec3(-impulse, 0, 0)));
  for (int i = 0; i < 60; ++i) world.step();
  return world;
}

TEST(Push, BreaksWhatItPushesTooHard) {
  const World held = pushed_column(0.5), broken = pushed_column(1000);
  EXPECT_TRUE(held.frame().crack_events.empty());
  EXPECT_FALSE(broken.frame().crack_events.empty());
  const EnergyAccount energy = broken.frame().energy;
  EXPECT_LT(std::abs(energy.unaccounted()), 0.01 * energy.turned_over());
}

TEST(Push, GivesTheSameBitsForOneTwoAndFourThreads) {
  const auto hashes = [](int threads) {
    const ThreadLimit limit(threads);
    return pushed_column(1000).state_hashes();
  };
  const StateHashes one = hashes(1);
  EXPECT_EQ(hashes(2), one);
  EXPECT_EQ(hashes(4), one);
}

TEST(Push, IsPartOfTheStateAndOfItsHashUntilItsStepIsMade) {
  const Scene scene = floating_block(2);
  World world(scene);
  const World before = world;
  world.push(push_at(world.frame(), scene.bodies[0].position, Vec3(1, 0, 0)));
  EXPECT_NE(world.state_hashes(), before.state_hashes());
  World copy = world;
  for (int i = 0; i < 3; ++i) world.step(), copy.step();
  EXPECT_EQ(world.state_hashes(), copy.state_hashes());
  EXPECT_LT((copy.frame().totals.momentum - Vec3(1, 0, 0)).norm(), 1e-9) << "it acts once";
}

TEST(Push, RefusesWhatIsNotThere) {
  World world(stack());
  const Push valid = push_at(world.frame(), Vec3(0, 0.75, 0), Vec3(0, 1, 0));
  Push missing = valid, outside = valid, endless = valid;
  missing.tet = -1;
  outside.weights = Vec3(0.5, 0.5, 0.5);
  endless.impulse.x() = std::nan("");
  for (const Push& wrong : {missing, outside, endless})
    EXPECT_NE(input_error_of([&] { world.push(wrong); }), "no error");
  Scene still = stack();
  still.analysis = Analysis::static_;
  still.bodies[0].supports = still.bodies[1].supports = {{HalfSpaceRegion{Vec3(0, -0.19, 0), -Vec3::UnitY()}}};
  World static_world(still);
  EXPECT_NE(input_error_of([&] { static_world.push(valid); }), "no error");
}

}  // namespace
}  // namespace griffith::testing
