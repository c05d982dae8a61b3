// What is put down stands: it does not sink, slide, creep or crack, and falls asleep.

#include <gtest/gtest.h>

#include "tests/world/contact/contact_case.h"
#include "tests/world/contact/contact_scenes.h"

namespace griffith {
namespace {

using testing::all_contact_cases;
using testing::box;
using testing::contact_cases;
using testing::ContactCase;
using testing::preset;

/// A granite cube on four granite feet, each `foot` of it wide and high.
Scene cube_on_feet(const ContactCase& at, double foot) {
  Scene scene = testing::empty_scene(at);
  const double height = foot * at.size;
  for (const double x : {-0.4, 0.4})
    for (const double z : {-0.4, 0.4})
      scene.bodies.push_back(box("foot " + std::to_string(scene.bodies.size()), Vec3::Constant(height),
                                 Vec3(x * at.size, height / 2, z * at.size), preset("granite"),
                                 Vec3::Constant(height / 2 / at.refinement)));
  scene.bodies.push_back(box("cube", Vec3::Constant(at.size), Vec3(0, height + at.size / 2, 0), preset("granite"),
                             Vec3::Constant(at.size / 4 / at.refinement)));
  return scene;
}

Scene cube_on_thin_feet(const ContactCase& at) { return cube_on_feet(at, 0.05); }
Scene cube_on_thick_feet(const ContactCase& at) { return cube_on_feet(at, 0.1); }

Scene two_beams(const ContactCase& at) {
  Scene scene = testing::empty_scene(at);
  const double width = at.size / 5;
  for (const double z : {0.0, width})
    scene.bodies.push_back(box(z > 0 ? "right" : "left", Vec3(at.size, width, width), Vec3(0, width / 2, z),
                               preset("wood_along_grain"), Vec3::Constant(width / at.refinement)));
  return scene;
}

/// Twelve levels of three wooden bars, each across those below; as high as `size`.
Scene jenga_tower(const ContactCase& at) {
  Scene scene = testing::empty_scene(at);
  const double height = at.size / 12, width = height * 5 / 3, length = 3 * width;
  for (int level = 0; level < 12; ++level)
    for (int bar = -1; bar <= 1; ++bar) {
      const bool along_x = level % 2 == 0;
      const double y = (level + 0.5) * height, off = bar * width;
      const Vec3 cell(width / at.refinement, height, width / at.refinement);
      scene.bodies.push_back(box("bar " + std::to_string(scene.bodies.size()),
                                 along_x ? Vec3(length, height, width) : Vec3(width, height, length),
                                 along_x ? Vec3(0, y, off) : Vec3(off, y, 0), preset("wood_along_grain"), cell));
    }
  return scene;
}

Scene ten_plates(const ContactCase& at) {
  Scene scene = testing::empty_scene(at);
  const double thickness = 0.06 * at.size, cell = at.size / 4 / at.refinement;
  for (int i = 0; i < 10; ++i)
    scene.bodies.push_back(box("plate " + std::to_string(i), Vec3(at.size, thickness, at.size),
                               Vec3(0, (i + 0.5) * thickness, 0), preset("granite"), Vec3(cell, thickness, cell)));
  return scene;
}

/// A block on a slope of 26.4°, below the friction angle of 31.0°; gravity leans instead of the ground.
Scene block_on_gentle_slope(const ContactCase& at) {
  Scene scene = testing::empty_scene(at);
  const double slope = 26.4 * M_PI / 180;
  scene.gravity = testing::kEarthGravity * Vec3(std::sin(slope), -std::cos(slope), 0);
  scene.ground->friction = 0.6;
  scene.bodies = {box("block", at.size * Vec3(1, 1.0 / 3, 1), Vec3(0, at.size / 6, 0), preset("granite"),
                      Vec3::Constant(at.size / 3 / at.refinement))};
  return scene;
}

/// A cube on one of half its size; `ratio` is that of their masses.
Scene heavy_on_light(const ContactCase& at, double ratio) {
  Scene scene = testing::empty_scene(at);
  const double side = at.size / 2;
  Material light = preset("granite"), heavy = preset("granite");
  light.density = 25000 * 8 / ratio;
  heavy.density = 25000;
  scene.bodies = {
      box("light", Vec3::Constant(side), Vec3(0, side / 2, 0), light, Vec3::Constant(side / 2 / at.refinement)),
      box("heavy", Vec3::Constant(at.size), Vec3(0, side + at.size / 2, 0), heavy,
          Vec3::Constant(at.size / 2 / at.refinement))};
  return scene;
}

Scene hundred_times_heavier(const ContactCase& at) { return heavy_on_light(at, 1e2); }
Scene thousand_times_heavier(const ContactCase& at) { return heavy_on_light(at, 1e3); }
Scene ten_thousand_times_heavier(const ContactCase& at) { return heavy_on_light(at, 1e4); }

struct RestingCase {
  const char* name;
  Scene (*scene)(const ContactCase&);
  ContactCase at;
};

std::ostream& operator<<(std::ostream& stream, const RestingCase& test) {
  return stream << test.name << ", " << test.at;
}

/// True for the tower of the finest bars in the shortest steps, a third of the time of all laws. Other towers have its
/// size, its mesh and its step.
bool repeats_towers(Scene (*scene)(const ContactCase&), const ContactCase& at) {
  return scene == jenga_tower && at.size < 1 && at.refinement == 2 && at.time_step < 1.0 / 200;
}

/// Each scene at sizes that its material can carry.
std::vector<RestingCase> resting_cases() {
  struct Kind {
    const char* name;
    Scene (*scene)(const ContactCase&);
    std::vector<double> sizes;
  };
  const std::vector<Kind> kinds = {
      {"CubeOnFeetOf5Percent", cube_on_thin_feet, {0.1, 1}},
      {"CubeOnFeetOf10Percent", cube_on_thick_feet, {0.1, 1}},
      {"TwoBeamsSideBySide", two_beams, {0.01, 0.15, 1, 10}},
      {"JengaTower", jenga_tower, {0.18, 1.8}},
      {"TenPlates", ten_plates, {0.05, 0.5, 5}},
      {"BlockOnGentleSlope", block_on_gentle_slope, {0.01, 0.3, 3}},
      {"HundredTimesHeavier", hundred_times_heavier, {0.01, 0.1, 1}},
      {"ThousandTimesHeavier", thousand_times_heavier, {0.01, 0.1, 1}},
      {"TenThousandTimesHeavier", ten_thousand_times_heavier, {0.01, 0.1, 1}},
  };
  std::vector<RestingCase> cases;
  for (const Kind& kind : kinds)
    for (const ContactCase& at : contact_cases(kind.sizes))
      if (all_contact_cases() || !repeats_towers(kind.scene, at)) cases.push_back({kind.name, kind.scene, at});
  return cases;
}

class RestingLaw : public testing::ContactLaw<RestingCase> {};

/// Steps on to `time` [s] unless something cracks.
void stand_to(World& world, double time) {
  while (world.frame().time < time - 1e-9 && !testing::has_crack(world.frame())) world.step();
}

TEST_P(RestingLaw, StandsWithoutSinkingCreepingOrCracking) {
  World world(GetParam().scene(GetParam().at));
  const std::vector<Vec3> start = testing::positions_of(world.frame());
  stand_to(world, 1);
  const std::vector<Vec3> settled = testing::positions_of(world.frame());
  testing::check_at_most("moved in 1 s [m]", testing::farthest_moved(start, world.frame()), 1e-4);
  testing::check_at_most("below the ground [m]", testing::depth_below(world.frame()), 1e-4);
  testing::check_equal("cracks in 1 s", testing::has_crack(world.frame()), 0);
  ASSERT_FALSE(testing::has_crack(world.frame()));
  stand_to(world, 5);
  testing::check_equal("asleep after 5 s", testing::all_asleep(world.frame()), 1);
  while (world.frame().time < 21 && !testing::all_asleep(world.frame()) && !testing::has_crack(world.frame()))
    world.step();
  testing::check_at_most("crept in 20 s [m]", testing::farthest_moved(settled, world.frame()), 1e-5);
  testing::check_equal("cracks in 20 s", testing::has_crack(world.frame()), 0);
}

INSTANTIATE_TEST_SUITE_P(Grid, RestingLaw, ::testing::ValuesIn(resting_cases()),
                         [](const auto& test) { return test.param.name + ("_" + testing::case_name(test.param.at)); });

}  // namespace
}  // namespace griffith
