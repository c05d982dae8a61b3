// Soft bodies that strike the ground or lie on it: Hertz's contact, and nothing that gets under the ground.

#include <gtest/gtest.h>

#include "tests/world/contact/contact_case.h"
#include "tests/world/contact/contact_scenes.h"

namespace griffith {
namespace {

using testing::ContactCase;
using testing::kEarthGravity;
using testing::preset;

/// Unbreakable rubber with this modulus where a body has a diameter of 1 m [Pa]: in proportion to its size, so that it
/// is squashed by the same share of its radius by what falls through the same share.
Material soft_rubber(double diameter, double modulus, double poisson_ratio) {
  Material material = testing::unbreakable(preset("rubber"));
  material.young_modulus = modulus * diameter;
  material.poisson_ratio = poisson_ratio;
  material.restitution = 0.3;
  return material;
}

Scene soft_ball(const ContactCase& at, const Material& material, double height) {
  Scene scene = testing::empty_scene(at);
  BodyDescription& ball = scene.bodies.emplace_back();
  ball.shape = SphereShape{at.size / 2, at.size / 6 / at.refinement};
  ball.material = material;
  ball.position = Vec3(0, at.size / 2 + height, 0);
  return scene;
}

double plane_strain_modulus(const Material& material) {
  return material.young_modulus / (1 - material.poisson_ratio * material.poisson_ratio);
}

/// The mass of the ball as it is meshed [kg].
double mass_of(const World& world) { return world.frame().totals.mass; }

class DroppedSoftBall : public testing::ContactLaw<ContactCase> {};

/// Velocity v after an implicit Euler step of m v' = m g - k x^(3/2), x' = v: the zero of a function that grows with v.
double step_of_hertz(double x, double v, double stiffness_per_mass, double h) {
  double low = -10 * std::abs(v) - 1, high = v + h * kEarthGravity;
  for (int i = 0; i < 100; ++i) {
    const double middle = 0.5 * (low + high), depth = std::max(0.0, x + h * middle);
    const double excess = middle - v - h * (kEarthGravity - stiffness_per_mass * std::pow(depth, 1.5));
    (excess > 0 ? high : low) = middle;
  }
  return low;
}

/// Depth to which a point of mass m, after a fall, presses Hertz's spring F = k d^(3/2) in steps h of implicit Euler
/// [m]: what the step's damping leaves of a squash that takes few steps, the weight's work included.
double squash_in_steps(double stiffness_per_mass, double fall, double h) {
  const double landing = std::sqrt(2 * fall / kEarthGravity), start = h * std::floor(landing / h);
  double v = kEarthGravity * start, x = 0.5 * kEarthGravity * start * start - fall, deepest = 0;
  while (v > 0) {
    v = step_of_hertz(x, v, stiffness_per_mass, h);
    x += h * v;
    deepest = std::max(deepest, x);
  }
  return deepest;
}

/// Drops the ball by its own diameter. Hertz (1882): F = (4/3) E* √R d^(3/2), in steps of implicit Euler. `share`: what
/// of d explicit steps of the same elements give, for a ball is no half-space; to within a tenth.
void check_squash(const ContactCase& at, const Material& material, double share) {
  const double radius = at.size / 2, fall = at.size;
  World world(soft_ball(at, material, fall));
  const double speed = std::sqrt(2 * kEarthGravity * fall);
  const double stiffness = 4.0 / 3 * plane_strain_modulus(material) * std::sqrt(radius) / mass_of(world);
  const double hertz = squash_in_steps(stiffness, fall, at.time_step);
  double lowest = world.frame().bodies[0].center_of_mass.y(), deepest = 0;
  while (world.frame().time < std::sqrt(2 * fall / kEarthGravity) + 4 * hertz / speed) {
    world.step();
    lowest = std::min(lowest, world.frame().bodies[0].center_of_mass.y());
    deepest = std::max(deepest, testing::depth_below(world.frame()));
  }
  const double got = radius - lowest, expected = share * hertz;
  testing::check_near("squashed by [m]", got, expected, 0.1);
  testing::check_at_most("below the ground [m]", deepest, 1e-3 * at.size);
}

TEST_P(DroppedSoftBall, IsSquashedByATenthOfItsSizeAsHertzSays) {
  check_squash(GetParam(), soft_rubber(GetParam().size, 1e6, 0.3), 0.82);
}

TEST_P(DroppedSoftBall, IsSquashedByAThirdOfItsSize) {
  check_squash(GetParam(), soft_rubber(GetParam().size, 1e5, 0.45), 0.67);
}

// A ball of 1 m is in contact for .1 s, three steps of 1/30 s, where its modulus is 1 MPa; smaller ones for less.
INSTANTIATE_TEST_SUITE_P(Grid, DroppedSoftBall, ::testing::ValuesIn(testing::contact_cases({1, 4, 10})),
                         testing::contact_case_name);

class RestingSoftBall : public testing::ContactLaw<ContactCase> {};

// Hertz: m g = (4/3) E* √R d^(3/2). Explicit steps of the same elements give three quarters of that d, a fifth of the
// radius: a ball is no half-space, and the contact is as wide as two or four elements.
TEST_P(RestingSoftBall, LiesOnTheGroundAsFlatAsHertzSays) {
  const ContactCase& at = GetParam();
  Material material = soft_rubber(at.size, 1e5, 0.3);
  material.stiffness_damping = 0.06 * std::sqrt(at.size);  // a third of the critical one
  World world(soft_ball(at, material, at.size / 100));
  testing::run_to_rest(world, 5);
  const double radius = at.size / 2;
  const double hertz = std::pow(
      mass_of(world) * kEarthGravity / (4.0 / 3 * plane_strain_modulus(material) * std::sqrt(radius)), 2.0 / 3);
  testing::check_at_most("below the ground [m]", testing::depth_below(world.frame()), 1e-4);
  testing::check_near("flattened by [m]", radius - world.frame().bodies[0].center_of_mass.y(), 0.76 * hertz, 0.12);
  testing::check_at_most("speed [m/s]", world.frame().bodies[0].velocity.norm(), 1e-3 * std::sqrt(at.size));
}

INSTANTIATE_TEST_SUITE_P(Grid, RestingSoftBall, ::testing::ValuesIn(testing::contact_cases({0.02, 0.2, 1, 10})),
                         testing::contact_case_name);

// A cube of rubber that sleeps, pressed by its weight, is woken by a small one. It has its weight and its stress at
// once: without, contacts would push it off its place, by work that nothing accounts for.
TEST(SleepingRubber, WakesInBalance) {
  const ContactCase at{1, 1, 1.0 / 60};
  Scene scene = testing::empty_scene(at);
  const Material rubber = testing::unbreakable(preset("rubber"));
  scene.bodies = {testing::box("cube", Vec3::Ones(), Vec3(0, 0.5, 0), rubber, Vec3::Constant(0.25)),
                  testing::box("small", Vec3::Constant(0.1), Vec3(0, 20, 0), rubber, Vec3::Constant(0.1))};
  World world(scene);
  while (!world.frame().bodies[0].asleep && world.frame().time < 1.9) world.step();
  ASSERT_TRUE(world.frame().bodies[0].asleep);
  const double height = world.frame().bodies[0].center_of_mass.y(), before = world.frame().energy.unaccounted();
  double fastest = 0;
  while (world.frame().bodies[0].asleep && world.frame().time < 2.5) world.step();
  fastest = world.frame().bodies[0].velocity.norm();
  ASSERT_FALSE(world.frame().bodies[0].asleep);
  // The momentum of 0.93 kg at 19.3 m/s, given to 930 kg.
  testing::check_at_most("speed [m/s]", fastest, 0.02);
  testing::check_at_most("moved [m]", std::abs(world.frame().bodies[0].center_of_mass.y() - height), 5e-4);
  testing::check_at_most("energy unaccounted [J]", std::abs(world.frame().energy.unaccounted() - before), 1e-3);
}

class ThrownPlate : public testing::ContactLaw<ContactCase> {};

/// A soft plate with a hole, upright, thrown at the ground.
Scene thrown_plate(const ContactCase& at, const Material& material, double speed) {
  Scene scene = testing::empty_scene(at);
  BodyDescription& plate = scene.bodies.emplace_back();
  plate.shape =
      PlateWithHoleShape{at.size * Vec3(1, 1, 0.1), 0.19 * at.size, Vec2::Constant(0.24 * at.size / at.refinement)};
  plate.material = material;
  plate.position = Vec3(0, at.size, 0);
  plate.velocity = Vec3(0, -speed, 0);
  return scene;
}

void check_stays_above(const ContactCase& at, const Material& material, double speed) {
  World world(thrown_plate(at, material, speed));
  double deepest = 0;
  while (world.frame().time < at.size / speed + 0.5) {
    world.step();
    deepest = std::max(deepest, testing::depth_below(world.frame()));
  }
  testing::check_at_most("below the ground [m]", deepest, 1e-3);
  testing::check_equal("inverted tets at the end", world.frame().report.inverted_tets, 0);
  testing::check_at_most("energy gained", testing::energy_gained(world.frame().energy), 0.01);
}

TEST_P(ThrownPlate, OfJellyStaysAboveTheGround) { check_stays_above(GetParam(), preset("jelly"), 5); }

TEST_P(ThrownPlate, OfRubberStaysAboveTheGround) { check_stays_above(GetParam(), preset("rubber"), 46); }

TEST_P(ThrownPlate, SofterThanItsSpeedStaysAboveTheGround) {
  Material soft;
  soft.young_modulus = 15000;
  soft.tensile_strength = 28000;
  check_stays_above(GetParam(), soft, 46);
}

INSTANTIATE_TEST_SUITE_P(Grid, ThrownPlate, ::testing::ValuesIn(testing::contact_cases({0.11, 1})),
                         testing::contact_case_name);

}  // namespace
}  // namespace griffith
