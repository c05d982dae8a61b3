#include "sim/scene/scene_setting.h"

#include <gtest/gtest.h>

#include "sim/core/error.h"
#include "sim/scene/scene_reader.h"
#include "sim/scene/scene_writer.h"
#include "tests/files/test_folder.h"
#include "tests/input_error_of.h"

namespace griffith {
namespace {

namespace fs = std::filesystem;

constexpr char kText[] = R"({"version": 1,
  "materials": {"soft": {"preset": "brick", "density": 1500}},
  "bodies": [{"name": "a", "shape": {"box": {"size": [1, 2, 3], "element_size": 0.5}}, "material": "soft"},
             {"name": "b", "shape": {"box": {"size": [1, 2, 3], "element_size": 0.5}}, "material": "soda_lime_glass"}],
  "projectiles": [{"speed": 30}]})";

fs::path scene_file() { return testing::written(testing::empty_folder() / "scene.json", kText); }

Scene with(const std::vector<std::string>& texts) {
  std::vector<SceneSetting> settings;
  for (const std::string& text : texts) settings.push_back(read_setting(text, "--set"));
  return read_scene(scene_file(), settings);
}

/// The message of the error that `texts` make; empty where they make none.
std::string refusal(const std::vector<std::string>& texts) {
  return input_error_of([&] { with(texts); });
}

TEST(SceneSetting, ChangesTheFieldAndNothingElse) {
  Scene expected = with({});
  expected.projectiles[0].speed = 12.5;
  EXPECT_EQ(with({"projectiles/0/speed=12.5"}), expected);
  EXPECT_EQ(with({"/projectiles/0/speed=12.5"}), expected);
  EXPECT_EQ(with({"#/projectiles/0/speed=12.5"}), expected);
}

TEST(SceneSetting, ReachesFieldsThatTheFileLeavesOut) {
  EXPECT_EQ(with({"gravity/1=-1.62"}).gravity, Vec3(0, -1.62, 0));
  EXPECT_EQ(with({"simulation/time_step=0.01"}).simulation.time_step, 0.01);
  EXPECT_EQ(with({"projectiles/0/position/2=9"}).projectiles[0].position, Vec3(0, 1, 9));
  EXPECT_EQ(with({"bodies/0/strength_scatter/seed=4"}).bodies[0].strength_scatter->seed, 4);
  EXPECT_FALSE(with({"ground=null"}).ground);
}

TEST(SceneSetting, ReachesIntoAMaterialThatIsGivenByName) {
  const Scene scene = with({"bodies/0/material/young_modulus=1e9"});
  EXPECT_EQ(scene.bodies[0].material.young_modulus, 1e9);
  EXPECT_EQ(scene.bodies[0].material.density, 1500);
  EXPECT_EQ(with({"bodies/1/material/density=2600"}).bodies[1].material.density, 2600);
}

TEST(SceneSetting, OfASharedMaterialActsOnAllThatHaveIt) {
  EXPECT_EQ(with({"materials/soft/tensile_strength=7e4"}).bodies[0].material.tensile_strength, 7e4);
}

TEST(SceneSetting, ALaterOneBuildsOnEarlierOnes) {
  const Scene scene = with({"bodies/0/material=soda_lime_glass", "bodies/0/material/density=2000"});
  Material glass = find_material_preset("soda_lime_glass").value();
  glass.density = 2000;
  EXPECT_EQ(scene.bodies[0].material, glass);
}

TEST(SceneSetting, OneNumberForAVectorMayGetComponents) {
  EXPECT_EQ(std::get<BoxShape>(with({"bodies/0/shape/box/element_size/1=0.25"}).bodies[0].shape).element_size,
            Vec3(0.5, 0.25, 0.5));
}

TEST(SceneSetting, RefusalsSayWhatWouldBeRight) {
  EXPECT_NE(
      refusal({"projectiles/0/sped=3"}).find("#/projectiles/0/sped: is not a known field (did you mean \"speed\"?"),
      std::string::npos)
      << refusal({"projectiles/0/sped=3"});
  EXPECT_NE(refusal({"bodies/2/position/0=3"}).find("has items 0 to 1"), std::string::npos);
  EXPECT_NE(refusal({"projectiles/0/speed/x=3"}).find("single value"), std::string::npos);
  EXPECT_NE(refusal({"projectiles/0/speed=-3"}).find("from 0 to"), std::string::npos);
  EXPECT_NE(refusal({"projectiles/0/speed=fast"}).find("#/projectiles/0/speed"), std::string::npos);
  EXPECT_NE(refusal({"bodies/0/strength_scatter/sed=3"}).find("seed"), std::string::npos);
  EXPECT_NE(refusal({"projectiles/0/speed"}).find("POINTER=VALUE"), std::string::npos);
  EXPECT_NE(refusal({"=3"}).find("is not a pointer"), std::string::npos);
  EXPECT_NE(refusal({"bodies//0=3"}).find("is not a pointer"), std::string::npos);
}

TEST(SceneSetting, AValueIsWhatTheSceneSaysOrMeans) {
  EXPECT_EQ(scene_value(scene_file(), "/projectiles/0/speed"), "30");
  EXPECT_EQ(scene_value(scene_file(), "/projectiles/0/mass"), "25");
  EXPECT_EQ(scene_value(scene_file(), "/bodies/0/material/density"), "1500");
  EXPECT_EQ(scene_value(scene_file(), "/bodies/0/strength_scatter"), "null");
  EXPECT_THROW(scene_value(scene_file(), "/bodies/7"), InputError);
}

/// Fields of every shipped scene, set to what they are, leave the scene as it was.
TEST(SceneSetting, SettingWhatIsThereChangesNothing) {
  int tried = 0;
  for (const auto& entry : fs::directory_iterator(fs::path(GRIFFITH_SOURCE_DIR) / "scenes")) {
    if (entry.path().extension() != ".json" || entry.path().stem().extension() == ".schema") continue;
    ++tried;
    const Scene scene = read_scene(entry.path());
    for (const char* pointer : {"/gravity/1", "/bodies/0/material/density", "/bodies/0/position",
                                "/simulation/time_step", "/bodies/0/material", "/view"}) {
      const std::vector<SceneSetting> same = {{pointer, scene_value(entry.path(), pointer)}};
      Scene read = read_scene(entry.path(), same);
      EXPECT_EQ(scene_to_json(read), scene_to_json(scene)) << entry.path() << pointer;
    }
  }
  EXPECT_GT(tried, 10);
}

}  // namespace
}  // namespace griffith
