#include "app/output/probe_table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "app/output/csv_field.h"
#include "program.h"
#include "sim/scene/scene_writer.h"
#include "sim/world/output/probes.h"

namespace griffith::app {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

Scene probed_wall() {
  Scene scene = small_wall();
  Probe probe;
  probe.name = "top, \"left\"";
  probe.body = scene.bodies[0].name;
  probe.quantities = {"velocity"};
  scene.probes = {probe};
  return scene;
}

TEST(ProbeTable, HasAHeadingAndARowAFrameWithEveryBit) {
  World world(probed_wall());
  ProbeTable table(world, "wall.json");
  world.step();
  table.add(world);
  EXPECT_THAT(table.csv(), StartsWith("step,time [s],\"top, \"\"left\"\".velocity.x [m/s]\",\"top"));
  std::istringstream lines(table.csv());
  std::string line, last;
  int rows = 0;
  while (std::getline(lines, line)) last = line, ++rows;
  EXPECT_EQ(rows, 3);
  double step = 0, time = 0, x = 0, y = 0, z = 0;
  ASSERT_EQ(std::sscanf(last.c_str(), "%lf,%lf,%lf,%lf,%lf", &step, &time, &x, &y, &z), 5) << last;
  const std::vector<double> values = probe_values(world.frame().probes, world.frame());
  EXPECT_EQ(step, 1);
  EXPECT_EQ(time, world.frame().time);
  EXPECT_EQ((std::vector{x, y, z}), values);
}

TEST(CsvField, IsNeverAFormula) {
  EXPECT_EQ(csv_field("=cmd|' /C calc'!A0"), "'=cmd|' /C calc'!A0");
  for (const char* text : {"+1+1", "-1+1", "@SUM(A1)", "\tx", "=1"})
    EXPECT_EQ(csv_field(text)[csv_field(text)[0] == '"'], '\'') << text;
  EXPECT_EQ(csv_field("=a,b"), "\"'=a,b\"");
  for (const char* number : {"-5", "+1.5", "-1e-9"}) EXPECT_EQ(csv_field(number), number);
}

TEST(ProbeTable, ANameIsNoFormula) {
  Scene scene = probed_wall();
  scene.probes[0].name = "=cmd|' /C calc'!A0";
  const ProbeTable table(World(scene), "wall.json");
  EXPECT_THAT(table.csv(), StartsWith("step,time [s],'=cmd|"));
}

TEST(ProbeTable, IsWrittenByTheProgram) {
  const auto scene = test_folder() / "probed.json", csv = test_folder() / "probed.csv";
  write_scene(probed_wall(), scene);
  const Outcome outcome = run_program("simulate --frames 4 " + scene.string() + " --probes " + csv.string());
  ASSERT_EQ(outcome.code, 0) << outcome.output;
  std::ifstream file(csv);
  EXPECT_EQ(std::count(std::istreambuf_iterator<char>(file), {}, '\n'), 6);
}

TEST(ProbeTable, ASceneWithoutProbesIsBadInput) {
  const Outcome outcome = run_program("simulate --frames 1 " + small_wall_file().string() + " --probes a.csv");
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.output, HasSubstr("small_wall.json#/probes"));
}

TEST(CheckCommand, SaysFirstWhatALargeSceneTakes) {
  const auto scene = test_file("large.json", R"({"version": 1, "bodies": [{"name": "block", "position": [0, 3, 0],
      "shape": {"box": {"size": [5, 5, 5], "element_size": 0.11}}}]})");
  const Outcome outcome = run_program("check " + scene.string());
  EXPECT_EQ(outcome.code, 0);
  EXPECT_THAT(outcome.output, ::testing::ContainsRegex("^about 4[0-9][0-9] thousand tetrahedra .*GB"));
}

TEST(CheckCommand, WarnsOfALoadThatActsOnNothingAndCallsTheSceneGood) {
  Scene scene = small_wall();
  scene.bodies[0].loads.push_back({SphereRegion{Vec3(0, 99, 0), 1}});
  const auto path = test_folder() / "loaded.json";
  write_scene(scene, path);
  const Outcome outcome = run_program("check " + path.string());
  EXPECT_EQ(outcome.code, 0);
  EXPECT_THAT(outcome.output, HasSubstr("warning: " + path.string() + "#/bodies/0/loads/0/region: holds no node"));
  EXPECT_THAT(outcome.output, HasSubstr("loaded.json: valid"));
}

}  // namespace
}  // namespace griffith::app
