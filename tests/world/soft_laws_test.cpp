// Soft bodies that strike the ground or lie on it: Hertz's contact, and nothing that gets under the ground.

#include <gtest/gtest.h>

#include <numbers>

#include "tests/world/contact_case.h"
#include "tests/world/contact_scenes.h"

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

/// The share of its energy that implicit Euler leaves an oscillation of angular frequency w after a quarter of a
/// period: each step has 1/(1 + w²h²) of it.
double share_left(double w, double h) { return std::pow(1 + w * w * h * h, -std::numbers::pi / 2 / (w * h)); }

/// Drops the ball by its own diameter. Hertz (1882): ½ m v² = (8/15) E* √R d^(5/2). `share`: what of d explicit steps
/// of the same elements give, for a ball is no half-space; to within a tenth, and what the step's damping takes.
void check_squash(const ContactCase& at, const Material& material, double share) {
  const double radius = at.size / 2, fall = at.size;
  World world(soft_ball(at, material, fall));
  const double energy = mass_of(world) * kEarthGravity * fall, speed = std::sqrt(2 * kEarthGravity * fall);
  const double hertz = std::pow(energy / (8.0 / 15 * plane_strain_modulus(material) * std::sqrt(radius)), 0.4);
  const double left = std::pow(share_left(speed / hertz, at.time_step), 0.4);
  double lowest = world.frame().bodies[0].center_of_mass.y(), deepest = 0;
  while (world.frame().time < std::sqrt(2 * fall / kEarthGravity) + 4 * hertz / speed) {
    world.step();
    lowest = std::min(lowest, world.frame().bodies[0].center_of_mass.y());
    deepest = std::max(deepest, testing::depth_below(world.frame()));
  }
  const double got = radius - lowest, expected = share * hertz;
  testing::record("squashed by [m]", got,
                  testing::short_text(0.9 * left * expected) + ".." + testing::short_text(1.1 * expected));
  EXPECT_GE(got, 0.9 * left * expected) << "squashed by [m]";
  EXPECT_LE(got, 1.1 * expected) << "squashed by [m]";
  testing::check_at_most("below the ground [m]", deepest, 1e-3 * at.size);
}

TEST_P(DroppedSoftBall, IsSquashedByATenthOfItsSizeAsHertzSays) {
  check_squash(GetParam(), soft_rubber(GetParam().size, 1e6, 0.3), 0.87);
}

TEST_P(DroppedSoftBall, IsSquashedByAThirdOfItsSize) {
  check_squash(GetParam(), soft_rubber(GetParam().size, 1e5, 0.45), 0.78);
}

// A ball of 1 m is in contact for .3 s, which nine steps of 1/30 s still show.
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
  while (world.frame().time < at.size / speed + 1) {
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
