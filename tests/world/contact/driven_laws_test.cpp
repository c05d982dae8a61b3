// What supports push and lift: the forces that they need, and what is jammed.

#include <gtest/gtest.h>

#include "tests/world/contact/contact_case.h"
#include "tests/world/contact/contact_scenes.h"
#include "tests/world/measures.h"

namespace griffith {
namespace {

using testing::box;
using testing::ContactCase;
using testing::kEarthGravity;
using testing::preset;

Support driven(const Region& region, const Vec3& velocity, double stop) {
  return {.region = region, .kind = SupportKind::prescribed, .velocity = velocity, .stop = stop};
}

/// Returns the mean force of the supports over the next steps [N].
Vec3 mean_of_reactions(World& world, int steps) {
  Vec3 force = Vec3::Zero();
  for (int step = 0; step < steps; ++step) {
    world.step();
    force += testing::sum_of_reactions(world.frame()) / steps;
  }
  return force;
}

/// Returns the number of steps in half a second.
int steps_of_half_a_second(const ContactCase& at) { return static_cast<int>(std::lround(0.5 / at.time_step)); }

class LiftingLaw : public testing::ContactLaw<ContactCase> {};

// The support carries the weight, ρgV: 104 N for a block of 20 x 10 x 20 cm.
TEST_P(LiftingLaw, ABlockLiftedInAirStaysWholeAndWeighsWhatItWeighs) {
  const ContactCase& at = GetParam();
  for (const double speed : {0.01, 0.05}) {
    Scene scene = testing::empty_scene(at);
    const Vec3 size = at.size * Vec3(1, 0.5, 1);
    scene.bodies = {
        box("block", size, Vec3(0, 5 * at.size, 0), preset("granite"), Vec3::Constant(at.size / 4 / at.refinement))};
    scene.bodies[0].supports = {
        driven(HalfSpaceRegion{Vec3(0, size.y() / 2, 0), Vec3::UnitY()}, speed * Vec3::UnitY(), 10)};
    World world(scene);
    testing::run_to(world, 0.5);
    const double force = mean_of_reactions(world, steps_of_half_a_second(at)).y();
    const std::string name = " at " + testing::short_text(100 * speed) + " cm/s";
    testing::check_near("force [N]" + name, force, 2650 * size.prod() * kEarthGravity);
    testing::check_equal("pieces" + name, static_cast<int>(world.frame().bodies.size()), 1);
    testing::check_equal("cracks" + name, static_cast<int>(world.frame().crack_events.size()), 0);
    testing::check_near("lifted [m]" + name, world.frame().bodies[0].center_of_mass.y() - 5 * at.size, speed, 0.01);
  }
}

INSTANTIATE_TEST_SUITE_P(Grid, LiftingLaw, ::testing::ValuesIn(testing::contact_cases({0.01, 0.2, 1})),
                         testing::contact_case_name);

class PressLaw : public testing::ContactLaw<ContactCase> {};

/// A granite platen that comes down at `speed` onto a pad of rubber without lateral strain, by `depth` in all.
Scene press(const ContactCase& at, double speed, double depth) {
  Scene scene = testing::empty_scene(at);
  const double pad = at.size / 2, platen = at.size / 2;
  Material rubber = testing::unbreakable(preset("rubber"));
  rubber.poisson_ratio = 0;
  scene.bodies = {
      box("pad", Vec3(at.size, pad, at.size), Vec3(0, pad / 2, 0), rubber, Vec3::Constant(at.size / 4 / at.refinement)),
      box("platen", Vec3(at.size, platen, at.size), Vec3(0, pad + platen / 2, 0), preset("granite"),
          Vec3::Constant(at.size / 4 / at.refinement))};
  scene.bodies[1].supports = {
      driven(HalfSpaceRegion{Vec3(0, platen / 2, 0), Vec3::UnitY()}, -speed * Vec3::UnitY(), depth / speed)};
  return scene;
}

// Hooke's law of a pad in uniaxial strain, for ν = 0: F = E A d / L; the support bears the platen's weight less. Its
// own weight has the pad shorter by ρ g L² / 2E beforehand.
TEST_P(PressLaw, GraniteIsSqueezedOnRubberWithTheForceOfItsStrain) {
  const ContactCase& at = GetParam();
  const double pad = at.size / 2, depth = 0.04 * pad, area = at.size * at.size;
  World world(press(at, depth / 0.5, depth));
  testing::run_to(world, 1);
  const Material rubber = preset("rubber");
  const double sagged = rubber.density * kEarthGravity * pad * pad / (2 * rubber.young_modulus);
  const double pressed = rubber.young_modulus * area * (depth - sagged) / pad;
  const double weight = 2650 * area * at.size / 2 * kEarthGravity;
  const double force = -mean_of_reactions(world, 10).y();
  testing::check_near("force on the pad [N]", force + weight, pressed, 0.05);
  testing::check_at_most("below the ground [m]", testing::depth_below(world.frame()), 1e-4);
  testing::check_equal("cracks", static_cast<int>(world.frame().crack_events.size()), 0);
  testing::check_at_most("energy unaccounted", testing::energy_unaccounted(world.frame().energy), 0.01);
}

INSTANTIATE_TEST_SUITE_P(Grid, PressLaw, ::testing::ValuesIn(testing::contact_cases({0.02, 0.2, 2})),
                         testing::contact_case_name);

class PushingLaw : public testing::ContactLaw<ContactCase> {};

// Coulomb: the support of a slow pusher, which hangs above the ground, bears µ m g and does the work of the friction.
TEST_P(PushingLaw, ABlockPushedAlongTheGroundTakesItsFriction) {
  const ContactCase& at = GetParam();
  const double size = at.size, gap = 0.05 * size, speed = 0.1 * size, friction = 0.4;
  Scene scene = testing::empty_scene(at);
  scene.ground->friction = friction;
  Material granite = preset("granite");
  granite.friction = friction;
  const Vec3 block(size, 0.5 * size, size), cell = Vec3::Constant(0.5 * size / at.refinement);
  scene.bodies = {box("block", block, Vec3(0, block.y() / 2, 0), granite, cell),
                  box("pusher", block, Vec3(-size, block.y() / 2 + gap, 0), granite, cell)};
  scene.bodies[1].material.friction = 0;  // else the two faces could carry some of the weight
  scene.bodies[1].supports = {
      driven(HalfSpaceRegion{Vec3(-size / 2, 0, 0), -Vec3::UnitX()}, speed * Vec3::UnitX(), 10)};
  World world(scene);
  testing::run_to(world, 0.5);
  const EnergyAccount before = world.frame().energy;
  const double from = world.frame().time;
  const double force = mean_of_reactions(world, steps_of_half_a_second(at)).x();
  const double expected = friction * granite.density * block.prod() * kEarthGravity;
  const double work = expected * speed * (world.frame().time - from);
  testing::check_near("force of the support [N]", force, expected);
  testing::check_near("work of the support [J]", world.frame().energy.supports - before.supports, work);
  testing::check_near("energy of friction [J]", world.frame().energy.contacts - before.contacts, work);
}

INSTANTIATE_TEST_SUITE_P(Grid, PushingLaw, ::testing::ValuesIn(testing::contact_cases({0.01, 0.1, 1})),
                         testing::contact_case_name);

class JammingLaw : public testing::ContactLaw<ContactCase> {};

/// A slender rod that leans by 40° from the upright, its foot on the ground, friction 2.
Scene leaning_rod(const ContactCase& at, const Material& material) {
  Scene scene = testing::empty_scene(at);
  scene.ground->friction = 2;
  const double width = at.size / 20, lean = 40 * M_PI / 180;
  scene.bodies = {box("rod", Vec3(width, at.size, width),
                      Vec3(0, (at.size * std::cos(lean) + width * std::sin(lean)) / 2, 0), material,
                      Vec3(width, width * 2, width) / at.refinement)};
  scene.bodies[0].rotation_degrees = Vec3(0, 0, 40);
  scene.bodies[0].material.friction = 2;
  return scene;
}

// Painlevé (1895): a rod that is thrust along the ground ahead of its foot has no motion without an impulse; it jams,
// and its energy cannot grow.
TEST_P(JammingLaw, ARodThatJamsEndsBounded) {
  const ContactCase& at = GetParam();
  Scene scene = leaning_rod(at, testing::unbreakable(preset("mild_steel")));
  scene.bodies[0].velocity = Vec3(3 * std::sqrt(at.size), 0, 0);
  World world(scene);
  testing::check_energy(world, 3);
  testing::run_to_rest(world, 10);
  testing::check_equal("asleep after 10 s", testing::all_asleep(world.frame()), 1);
  testing::check_at_most("below the ground [m]", testing::depth_below(world.frame()), 1e-4);
}

/// Material of a driven rod, so stiff that it bends by the same share under its weight at every size.
Material rod_material(double size) {
  Material stiff = testing::unbreakable(preset("rubber"));
  stiff.young_modulus = 2e9 * size;
  return stiff;
}

constexpr double kDrivenStrain = 0.001;

/// A rod whose top is driven down along its axis by a thousandth of its length within .5 s. Friction 2 holds the foot,
/// as 2 > tan 40°.
Scene driven_rod(const ContactCase& at) {
  const double duration = 0.5, lean = 40 * M_PI / 180;
  Scene scene = leaning_rod(at, rod_material(at.size));
  scene.bodies[0].supports = {driven(HalfSpaceRegion{Vec3(0, at.size / 2, 0), Vec3::UnitY()},
                                     kDrivenStrain * at.size / duration * Vec3(std::sin(lean), -std::cos(lean), 0),
                                     duration)};
  return scene;
}

// Hooke: it takes at most ½ E V ε², with a force of at most E A ε; where it bends, less.
TEST_P(JammingLaw, ARodDrivenIntoTheGroundTakesNoMoreThanItsStrain) {
  const ContactCase& at = GetParam();
  const Material stiff = rod_material(at.size);
  const double volume = at.size * at.size * at.size / 400;
  World world(driven_rod(at));
  testing::check_energy(world, 2);
  const double weight = stiff.density * volume * kEarthGravity;
  testing::check_at_most(
      "elastic energy [J]", world.frame().energy.elastic,
      0.5 * stiff.young_modulus * volume * kDrivenStrain * kDrivenStrain + weight * kDrivenStrain * at.size);
  testing::check_at_most("force of the support [N]", testing::sum_of_reactions(world.frame()).norm(),
                         1.05 * stiff.young_modulus * volume / at.size * kDrivenStrain + weight);
  testing::check_at_most("below the ground [m]", testing::depth_below(world.frame()), 1e-4);
}

// The foot sticks from the start, so the force does not depend on the step.
TEST(Jamming, TheForceOnADrivenRodDoesNotDependOnTheStep) {
  std::vector<double> forces;
  for (const double steps : {30, 60, 250}) {
    World world(driven_rod({1, 1, 1 / steps}));
    testing::run_to(world, 2);
    EXPECT_LT(testing::depth_below(world.frame()), 1e-6) << "step 1/" << steps << " s";
    forces.push_back(testing::sum_of_reactions(world.frame()).norm());
  }
  EXPECT_NEAR(forces[1], forces[0], 0.02 * forces[0]);
  EXPECT_NEAR(forces[2], forces[0], 0.02 * forces[0]);
}

INSTANTIATE_TEST_SUITE_P(Grid, JammingLaw, ::testing::ValuesIn(testing::contact_cases({0.1, 1, 10})),
                         testing::contact_case_name);

}  // namespace
}  // namespace griffith
