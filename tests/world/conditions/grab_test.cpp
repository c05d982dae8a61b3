// Grabs by closed forms and balances: the damped oscillator, the hanging weight, the bent beam, impulse and momentum.

#include "sim/world/conditions/grab.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "sim/core/parallel.h"
#include "sim/world/setup/build_world.h"
#include "sim/world/state/world_state.h"
#include "sim/world/step.h"
#include "sim/world/world.h"
#include "tests/input_error_of.h"
#include "tests/world/held_scenes.h"
#include "tests/world/scenes.h"

namespace griffith::testing {
namespace {

constexpr double kGravity = 9.80665;

/// Returns a grab of the material at `place` [m], or of the nearest material, pulled to `target`.
Grab grab_at(const Frame& frame, const Vec3& place, const Vec3& target, const GrabSpring& spring = {}) {
  const auto [tet, weights] = place_at(frame, place);
  return {tet, weights, target, spring};
}

/// Returns the largest distance of a grabbed block from the closed form over a second, as a fraction of its way: a
/// point mass at rest whose spring's end is put 1 m away.
double error_of_oscillator(double time_step) {
  const GrabSpring spring{.frequency = 2, .damping_ratio = 0.3, .strength = 1e6};
  Scene scene = floating_block();
  scene.simulation.time_step = time_step;
  World world(scene);
  const Vec3 start = scene.bodies[0].position, way(0.6, 0.8, 0);
  world.grab(grab_at(world.frame(), start, start + way, spring));
  const double omega = 2 * std::numbers::pi * spring.frequency, decay = spring.damping_ratio * omega;
  const double damped = std::sqrt(omega * omega - decay * decay);
  double error = 0;
  while (world.frame().time < 1) {
    world.step();
    const double t = world.frame().time;
    const double left = std::exp(-decay * t) * (std::cos(damped * t) + decay / damped * std::sin(damped * t));
    error = std::max(error, (world.frame().grab->point - (start + (1 - left) * way)).norm());
  }
  return error;
}

TEST(Grab, APointMassIsADampedOscillator) {
  const double coarse = error_of_oscillator(1e-3), fine = error_of_oscillator(5e-4);
  EXPECT_LT(fine, 0.01);
  EXPECT_NEAR(coarse / fine, 2, 0.2) << "an error of first order in the time step";
}

TEST(Grab, TheImpulseOfTheForceIsTheChangeOfMomentum) {
  for (const double young_modulus : {1e5, 1e10}) {
    Scene scene = floating_block(3, young_modulus);
    scene.simulation.time_step = 1.0 / 60;
    World world(scene);
    const Vec3 corner = scene.bodies[0].position + Vec3(0.19, 0.15, 0.2);
    world.grab(grab_at(world.frame(), corner, corner + Vec3(1, 0, 0)));
    Vec3 impulse = Vec3::Zero(), torque = Vec3::Zero();
    const Vec3 turned = world.frame().totals.angular_momentum;
    for (int i = 0; i < 40; ++i) {
      if (i % 7 == 0) world.move_grab(corner + Vec3(std::cos(i), std::sin(i), 0.1 * i));
      const Vec3 point = world.frame().grab->point;
      world.step();
      const Vec3 force = world.frame().grab->force;
      impulse += scene.simulation.time_step * force;
      torque += scene.simulation.time_step * point.cross(force);
      ASSERT_LT((world.frame().totals.momentum - impulse).norm(), 1e-9 * (1 + impulse.norm())) << "step " << i;
    }
    EXPECT_GT(impulse.norm(), 1);
    EXPECT_LT((world.frame().totals.angular_momentum - turned - torque).norm(), 0.02 * torque.norm());
  }
}

TEST(Grab, APieceAtRestHangsBelowTheTargetByItsWeightOverTheStiffness) {
  const GrabSpring spring{.frequency = 1.5, .damping_ratio = 1};
  const double omega = 2 * std::numbers::pi * spring.frequency;
  for (const double young_modulus : {2e5, 1e10}) {
    Scene scene = floating_block(2, young_modulus);
    scene.gravity = Vec3(0, -kGravity, 0);
    scene.simulation.time_step = 1.0 / 60;
    scene.bodies[0].material.mass_damping = 2;  // lets it stop swinging
    World world(scene);
    const Vec3 top = scene.bodies[0].position + Vec3(0.02, 0.19, -0.01);
    world.grab(grab_at(world.frame(), top, top, spring));
    for (int i = 0; i < 1200; ++i) world.step();
    const GrabView grab = *world.frame().grab;
    const double weight = world.frame().totals.mass * kGravity;
    EXPECT_LT((grab.force - Vec3(0, weight, 0)).norm(), 2e-3 * weight) << young_modulus;
    EXPECT_LT((grab.target - grab.point - Vec3(0, kGravity / omega / omega, 0)).norm(), 5e-4) << young_modulus;
  }
}

TEST(Grab, ItsForceIsLimitedByTheWeightOfThePiece) {
  Scene scene = floating_block(2);
  scene.bodies[0].supports = {{HalfSpaceRegion{Vec3(0, -0.19, 0), -Vec3::UnitY()}}};
  World world(scene);
  const Vec3 top = scene.bodies[0].position + Vec3(0, 0.19, 0);
  world.grab(grab_at(world.frame(), top, top + Vec3(50, 0, 0), {.strength = 3}));
  for (int i = 0; i < 60; ++i) world.step();
  const GrabView grab = *world.frame().grab;
  const double limit = 3 * world.frame().totals.mass * kGravity;
  EXPECT_NEAR(grab.max_force, limit, 1e-6 * limit);
  EXPECT_NEAR(grab.force.norm(), limit, 1e-6 * limit);
}

/// A strip of glass, 0.4 m long, held at its left end, weightless.
Scene cantilever() {
  Scene scene;
  scene.gravity.setZero();
  scene.ground.reset();
  scene.simulation.time_step = 1e-3;
  scene.simulation.fracture = false;
  BodyDescription strip;
  strip.shape = BoxShape{Vec3(0.4, 0.02, 0.01), Vec3(0.02, 0.02, 0.01), BoxPattern::five_tet};
  strip.elements = ElementOrder::quadratic;
  strip.material = *find_material_preset("soda_lime_glass");
  strip.material.poisson_ratio = 0;
  strip.material.mass_damping = 100;
  strip.supports = {{HalfSpaceRegion{Vec3(-0.2, 0, 0), -Vec3::UnitX()}}};
  scene.bodies = {strip};
  return scene;
}

TEST(Grab, ASupportedBeamBendsByTheForceAtItsTip) {
  const Scene scene = cantilever();
  World world(scene);
  const Vec3 tip(0.2, 0, 0);
  world.grab(grab_at(world.frame(), tip, tip + Vec3(0, 0, 0.05), {.strength = 1e4}));
  const Vec3 start = world.frame().grab->point;
  for (int i = 0; i < 1500; ++i) world.step();
  const GrabView grab = *world.frame().grab;
  const double inertia = 0.02 * std::pow(0.01, 3) / 12, bending = scene.bodies[0].material.young_modulus * inertia;
  const double expected = grab.force.z() * std::pow(start.x() + 0.2, 3) / (3 * bending);
  EXPECT_GT(expected, 1e-4);
  EXPECT_NEAR(grab.point.z() - start.z(), expected, 0.02 * expected);
}

/// Returns the work of the grab's force along the way of its point in a run that lifts a block, swings and drops it.
double work_of_lifting(World& world, const Vec3& place) {
  world.grab(grab_at(world.frame(), place, place));
  double work = 0;
  for (int i = 0; i < 90; ++i) {
    world.move_grab(place + Vec3(0.3 * std::sin(0.1 * i), 0.01 * i, 0));
    const Vec3 before = world.frame().grab->point;
    world.step();
    work += world.frame().grab->force.dot(world.frame().grab->point - before);
  }
  world.release();
  for (int i = 0; i < 60; ++i) world.step();
  return work;
}

TEST(Grab, TheEnergyAccountClosesWithTheWorkOfTheForce) {
  for (const ElementOrder order : {ElementOrder::linear, ElementOrder::quadratic}) {
    Scene scene = floating_block(order == ElementOrder::linear ? 2 : 1);
    scene.simulation.time_step = 1.0 / 60;
    scene.gravity = Vec3(0, -kGravity, 0);
    scene.ground = Ground{};
    scene.bodies[0].position.y() = 0.2;
    scene.bodies[0].elements = order;
    World world(scene);
    const double work = work_of_lifting(world, Vec3(0.19, 0.39, 0.1));
    const EnergyAccount energy = world.frame().energy;
    EXPECT_GT(work, 0.5 * world.frame().totals.mass * kGravity);
    EXPECT_NEAR(energy.loads, work, 0.01 * work);
    EXPECT_LT(std::abs(energy.unaccounted()), 0.005 * energy.turned_over());
  }
}

TEST(Grab, WakesAPieceAndKeepsItAwakeUntilItIsReleased) {
  World world(stack());
  const auto asleep = [&] { return world.frame().bodies[1].asleep; };
  for (int i = 0; i < 300 && !asleep(); ++i) world.step();
  ASSERT_TRUE(asleep());
  const Vec3 top(0, 0.75, 0);
  world.grab(grab_at(world.frame(), top, top + Vec3(0, 0.5, 0)));
  for (int i = 0; i < 120; ++i) world.step();
  EXPECT_GT(world.frame().bodies[1].center_of_mass.y(), 0.8);
  EXPECT_FALSE(asleep()) << "though it hangs still";
  world.release();
  EXPECT_FALSE(world.frame().grab);
  for (int i = 0; i < 600 && !asleep(); ++i) world.step();
  EXPECT_TRUE(asleep());
}

/// A brick column, its foot held, that a grab pulls at its top.
World pulled_column(const Vec3& pull) {
  Scene scene;
  scene.simulation.time_step = 1.0 / 60;
  scene.bodies = {wall(Vec3(0.4, 1.6, 0.4), 0.2, brick(0.1))};
  World world(scene);
  const Vec3 top(0.05, 1.55, 0);
  world.grab(grab_at(world.frame(), top, top + pull));
  for (int i = 0; i < 120; ++i) world.step();
  return world;
}

TEST(Grab, BreaksWhatItPullsTooHardAndCarriesAPieceAway) {
  const World held = pulled_column(Vec3(0.001, 0, 0)), broken = pulled_column(Vec3(1.5, 0.2, 0));
  EXPECT_TRUE(held.frame().crack_events.empty());
  EXPECT_FALSE(broken.frame().crack_events.empty());
  const GrabView grab = *broken.frame().grab;
  EXPECT_FALSE(broken.frame().bodies[grab.body].supported);
  EXPECT_LT((grab.point - grab.target).norm(), 0.1);
  const EnergyAccount energy = broken.frame().energy;
  EXPECT_LT(std::abs(energy.unaccounted()), 0.01 * energy.turned_over());
}

TEST(Grab, GivesTheSameBitsForOneTwoAndFourThreads) {
  const auto hashes = [](int threads) {
    const ThreadLimit limit(threads);
    return pulled_column(Vec3(1.5, 0.2, 0)).state_hashes();
  };
  const StateHashes one = hashes(1);
  EXPECT_EQ(hashes(2), one);
  EXPECT_EQ(hashes(4), one);
}

TEST(Grab, IsPartOfTheStateAndOfItsHash) {
  World world(stack());
  world.grab(grab_at(world.frame(), Vec3(0, 0.75, 0), Vec3(0.5, 1, 0)));
  for (int i = 0; i < 5; ++i) world.step();
  World copy = world, moved = world;
  moved.move_grab(Vec3(0.5, 1, 1e-12));
  EXPECT_NE(moved.state_hashes(), world.state_hashes());
  for (int i = 0; i < 20; ++i) world.step(), copy.step();
  EXPECT_EQ(world.state_hashes(), copy.state_hashes());
}

/// Returns the place of a point in the undeformed body [m].
Vec3 rest_place(const WorldState& world, const MaterialPoint& point) {
  const auto at = [&](int corner) { return world.mesh->rest_positions[world.mesh->tets[point.tet][corner]]; };
  Vec3 place = (1 - point.weights.sum()) * at(0);
  for (int i = 0; i < 3; ++i) place += point.weights[i] * at(i + 1);
  return place;
}

TEST(Grab, StaysWithItsMaterialThroughCuts) {
  Scene scene = struck_block(brick(0.1));
  scene.bodies[0].remeshing = true;
  WorldState world = build_world(scene);
  World view(scene);
  int cut = 0;
  for (const Vec3& place : {Vec3(0.3, 0.2, 0.2), Vec3(0.1, 0.4, 0.22), Vec3(-0.2, 0, 0.1)}) {
    WorldState run = world;
    const Grab grab = grab_at(view.frame(), place, place);
    begin_grab(run, grab);
    for (int i = 0; i < 60; ++i) advance(run);
    const MaterialPoint& now = *run.loads.back().point;
    EXPECT_LT((rest_place(run, now) - place).norm(), 1e-9);
    EXPECT_GE(std::min(now.weights.minCoeff(), 1 - now.weights.sum()), -1e-6);
    cut += now.tet.index() != grab.tet || now.weights != grab.weights;
  }
  EXPECT_GT(cut, 0) << "a cut went through a grabbed tet";
}

TEST(Grab, RefusesWhatIsNotThere) {
  World world(stack());
  const Grab valid = grab_at(world.frame(), Vec3(0, 0.75, 0), Vec3::Zero());
  Grab missing = valid, outside = valid, lost = valid;
  missing.tet = 1 << 20;
  outside.weights = Vec3(0.5, 0.5, 0.5);
  lost.target.x() = std::nan("");
  EXPECT_NE(input_error_of([&] { world.grab(missing); }), "no error");
  EXPECT_NE(input_error_of([&] { world.grab(outside); }), "no error");
  EXPECT_NE(input_error_of([&] { world.grab(lost); }), "no error");
  EXPECT_NE(input_error_of([&] { world.move_grab(Vec3::Zero()); }), "no error");
  EXPECT_FALSE(world.frame().grab);
  Scene still = stack();
  still.analysis = Analysis::static_;
  still.bodies[0].supports = still.bodies[1].supports = {{HalfSpaceRegion{Vec3(0, -0.19, 0), -Vec3::UnitY()}}};
  World static_world(still);
  EXPECT_NE(input_error_of([&] { static_world.grab(valid); }), "no error");
}

}  // namespace
}  // namespace griffith::testing
