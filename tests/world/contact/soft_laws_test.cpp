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

/// Depth d to which a point of mass m, after a fall, presses Hertz's spring F = k d^(3/2) [m]: m g (fall + d) =
/// (2/5) k d^(5/2).
double hertz_squash(double stiffness_per_mass, double fall) {
  double low = 0, high = 10 * fall;
  for (int i = 0; i < 100; ++i) {
    const double middle = 0.5 * (low + high);
    (kEarthGravity * (fall + middle) > 0.4 * stiffness_per_mass * std::pow(middle, 2.5) ? low : high) = middle;
  }
  return low;
}

/// The least of some heights at equal intervals of time, between which they follow parabolas.
double lowest_of(const std::vector<double>& heights) {
  const auto at = std::ranges::min_element(heights);
  const double before = *(at - 1), after = *(at + 1), bend = before - 2 * *at + after;
  return *at - (after - before) * (after - before) / (8 * bend);
}

/// Drops the ball by its own diameter. Hertz (1882): F = (4/3) E* √R d^(3/2). `share`: what elements give of d at any
/// time step, for a ball is no half-space; to within a tenth.
void check_squash(const ContactCase& at, const Material& material, double share) {
  const double radius = at.size / 2, fall = at.size;
  World world(soft_ball(at, material, fall));
  const double speed = std::sqrt(2 * kEarthGravity * fall);
  const double stiffness = 4.0 / 3 * plane_strain_modulus(material) * std::sqrt(radius) / mass_of(world);
  const double hertz = hertz_squash(stiffness, fall);
  std::vector<double> heights;
  double deepest = 0;
  while (world.frame().time < std::sqrt(2 * fall / kEarthGravity) + 4 * hertz / speed) {
    world.step();
    heights.push_back(world.frame().bodies[0].center_of_mass.y());
    deepest = std::max(deepest, testing::depth_below(world.frame()));
  }
  const double got = radius - lowest_of(heights), expected = share * hertz;
  testing::check_near("squashed by [m]", got, expected, 0.1);
  testing::check_at_most("below the ground [m]", deepest, 1e-3 * at.size);
}

TEST_P(DroppedSoftBall, IsSquashedByATenthOfItsSizeAsHertzSays) {
  check_squash(GetParam(), soft_rubber(GetParam().size, 1e6, 0.3), 0.82);
}

TEST_P(DroppedSoftBall, IsSquashedByAThirdOfItsSize) {
  check_squash(GetParam(), soft_rubber(GetParam().size, 1e5, 0.45), 0.67);
}

/// A ball of 0.1 m that falls by half a meter on the ground at a height of −`base` [m].
Scene dropped_ball(const Material& material, double element_size, double time_step, double base = 0) {
  Scene scene;
  scene.simulation.time_step = time_step;
  scene.ground->restitution = 1;
  scene.ground->height = -base;
  BodyDescription& ball = scene.bodies.emplace_back();
  ball.shape = SphereShape{0.05, element_size};
  ball.material = material;
  ball.position = Vec3(0, 0.55, 0);
  return scene;
}

/// Speed of the dropped ball before its impact [m/s].
const double kSpeedOfFall = std::sqrt(2 * kEarthGravity * 0.5);

/// Returns its highest speed upward [m/s].
double speed_of_return(const Scene& scene) {
  World world(scene);
  double fastest = 0;
  while (world.frame().time < 0.45) {
    world.step();
    fastest = std::max(fastest, world.frame().bodies[0].velocity.y());
  }
  return fastest;
}

// A ball of rubber is in contact for 9 ms: less than a step, or two.
TEST(BouncingBall, OfRubberReturnsItsEnergyOnAnyMeshAtAnyStep) {
  for (const double element_size : {0.025, 0.0125})
    for (const double rate : {30.0, 60.0, 250.0, 1000.0}) {
      const double after = speed_of_return(dropped_ball(preset("rubber"), element_size, 1 / rate));
      // As fast as at the end of the step that follows.
      EXPECT_GT(after, 0.93 * kSpeedOfFall - 1.5 * kEarthGravity / rate) << element_size << ", 1/" << rate;
      EXPECT_LT(after, kSpeedOfFall) << element_size << ", 1/" << rate;
    }
}

TEST(BouncingBall, BouncesFromWhatIsHardAsFromTheGround) {
  const Material brick = preset("brick");
  const Vec3 cell = Vec3::Constant(0.1);
  for (const double rate : {30.0, 60.0, 250.0})
    for (const bool is_held : {true, false}) {
      Scene scene = dropped_ball(preset("rubber"), 0.025, 1 / rate, 0.3);
      for (int i = 0; i < 3; ++i)
        scene.bodies.push_back(
            testing::box("brick " + std::to_string(i), Vec3(0.2, 0.1, 0.2), Vec3(0, -0.05 - 0.1 * i, 0), brick, cell));
      if (is_held) scene.bodies[1].supports = {Support{HalfSpaceRegion{Vec3(0, -0.049, 0), -Vec3::UnitY()}}};
      const double after = speed_of_return(scene);
      EXPECT_GT(after, (is_held ? 0.93 : 0.88) * kSpeedOfFall - 1.5 * kEarthGravity / rate) << is_held << " " << rate;
      EXPECT_LT(after, kSpeedOfFall) << is_held << " " << rate;
    }
}

// Without microsteps it came back at .2 to 5 m/s, by the step.
TEST(BouncingBall, OfSteelReturnsFromRubberAlikeAtEveryStep) {
  for (const double rate : {30.0, 60.0, 250.0}) {
    Scene scene;
    scene.simulation.time_step = 1 / rate;
    scene.bodies = {
        testing::box("rubber", Vec3(0.3, 0.2, 0.3), Vec3(0, 0.1, 0), preset("rubber"), Vec3::Constant(0.05))};
    ProjectileBurst& burst = scene.projectiles.emplace_back();
    burst.position = Vec3(0, 0.4, 0);
    burst.direction = -Vec3::UnitY();
    burst.speed = 8;
    burst.mass = 5;
    burst.radius = 0.05;
    World world(scene);
    testing::run_to(world, 0.2);
    const ProjectileView ball = world.frame().projectiles[0];
    const double at_surface = ball.velocity.squaredNorm() + 2 * kEarthGravity * (ball.position.y() - 0.25);
    EXPECT_NEAR(std::sqrt(at_surface), 6.61, 0.07) << "1/" << rate;
  }
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
