#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <set>

#include "app/regress/suite.h"
#include "program.h"
#include "renderer/image.h"
#include "sim/core/error.h"
#include "sim/scene/scene_writer.h"

namespace griffith::app {
namespace {

namespace fs = std::filesystem;

std::string content_of(const fs::path& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// A suite of one scene in its folder, accepted as it is.
class RegressCommand : public ::testing::Test {
 protected:
  RegressCommand() : suite_(test_folder() / "a suite") {
    fs::remove_all(suite_);
    fs::create_directories(suite_);
    write_scene(small_wall(), suite_ / "wall.json");
    std::ofstream(suite_ / "suite.json") << R"({"defaults": {"size": [160, 100]}, "pictures": [
        {"name": "wall", "scene": "wall.json", "frames": [0, 9], "views": ["body", "utilization"]},
        {"name": "panels", "scene": "wall.json", "size": [640, 400], "ui": true}]})";
  }

  Outcome regress(const std::string& options) { return run_program("regress '" + suite_.string() + "' " + options); }

  void accept_all() {
    const Outcome outcome = regress("--accept");
    ASSERT_EQ(outcome.code, 0) << outcome.output;
  }

  fs::path golden(const std::string& file) const {
    for (const auto& folder : fs::directory_iterator(suite_ / "goldens")) return folder.path() / file;
    return {};
  }

  fs::path suite_;
};

TEST_F(RegressCommand, WhatWasAcceptedPassesAndWhatWasNotDoesNot) {
  const Outcome before = regress("");
  EXPECT_EQ(before.code, 1);
  EXPECT_NE(before.output.find("missing_golden: wall_body_0000"), std::string::npos) << before.output;
  accept_all();
  const Outcome after = regress("--jobs 2");
  EXPECT_EQ(after.code, 0) << after.output;
  EXPECT_NE(after.output.find("5 pictures, 0 differ"), std::string::npos) << after.output;
  fs::remove(golden("wall_body_0009.png"));
  EXPECT_EQ(regress("").code, 1);
}

TEST_F(RegressCommand, AnotherStepThanThatOfTheGoldenPictureIsReported) {
  const auto draw_step = [this](int step) {
    std::ofstream(suite_ / "suite.json") << R"({"defaults": {"size": [160, 100]}, "pictures": [
        {"name": "wall", "scene": "wall.json", "frames": )"
                                         << step << "}]}";
  };
  draw_step(3);
  accept_all();
  draw_step(4);
  const Outcome later = regress("");
  EXPECT_EQ(later.code, 1);
  EXPECT_NE(later.output.find("The golden picture is of another job, frame: 3, now 4."), std::string::npos)
      << later.output;
  EXPECT_EQ(later.output.find("The simulation changed"), std::string::npos) << later.output;
}

TEST_F(RegressCommand, AChangedSimulationIsDistinguishedFromAChangedDrawing) {
  accept_all();
  Scene scene = small_wall();
  scene.projectiles[0].speed *= 1.001;
  write_scene(scene, suite_ / "wall.json");
  const Outcome simulation = regress("--only wall_body_0009");
  EXPECT_EQ(simulation.code, 1);
  EXPECT_NE(simulation.output.find("failed: wall_body_0009: The simulation changed"), std::string::npos)
      << simulation.output;
  EXPECT_NE(simulation.output.find("1 field of the scene changed, projectiles/0/speed: 40, now 40.03999999999999"),
            std::string::npos)
      << simulation.output;
  EXPECT_NE(content_of(suite_ / "report.html").find("<tr class=\"differs\"><td>projectiles/0/speed</td><td>40</td>"),
            std::string::npos);
  scene = small_wall();
  scene.view.edge_width = 3;
  write_scene(scene, suite_ / "wall.json");
  const Outcome drawing = regress("--only wall");
  EXPECT_EQ(drawing.code, 1);
  EXPECT_NE(drawing.output.find("failed: wall_utilization_0009: The simulation is identical; the drawing changed"),
            std::string::npos)
      << drawing.output;
  EXPECT_EQ(drawing.output.find("The simulation changed"), std::string::npos) << drawing.output;
}

TEST_F(RegressCommand, AcceptingOnePictureLeavesTheOthers) {
  accept_all();
  Scene scene = small_wall();
  scene.view.edge_width = 3;
  write_scene(scene, suite_ / "wall.json");
  const std::string other = content_of(golden("wall_utilization_0009.png"));
  const Outcome accepted = regress("--accept wall_utilization_0000");
  EXPECT_EQ(accepted.code, 0) << accepted.output;
  EXPECT_EQ(content_of(golden("wall_utilization_0009.png")), other);
  EXPECT_EQ(regress("--only wall_utilization_0009").code, 1);
  const Outcome alone = regress("--only wall_utilization_0000");
  EXPECT_EQ(alone.code, 0) << alone.output;
  EXPECT_NE(alone.output.find("1 pictures, 0 differ"), std::string::npos) << alone.output;
  EXPECT_EQ(regress("--accept nothing_of_that_name").code, 2);
}

TEST_F(RegressCommand, AJobThatCannotBeDrawnFailsAloneAndSaysWhy) {
  accept_all();
  std::ofstream(suite_ / "suite.json") << R"({"defaults": {"size": [160, 100]}, "pictures": [
      {"name": "gone", "scene": "gone.json"}, {"name": "wall", "scene": "wall.json", "views": ["body"]}]})";
  const Outcome outcome = regress("--junit '" + (test_folder() / "results.xml").string() + "'");
  EXPECT_EQ(outcome.code, 1);
  EXPECT_NE(outcome.output.find("error: gone: "), std::string::npos) << outcome.output;
  EXPECT_NE(outcome.output.find("gone.json"), std::string::npos) << outcome.output;
  EXPECT_EQ(outcome.output.find("Graphics:"), std::string::npos) << outcome.output;
  EXPECT_NE(outcome.output.find("no job draws the golden picture panels"), std::string::npos) << outcome.output;
  EXPECT_NE(content_of(test_folder() / "results.xml").find("errors=\"1\""), std::string::npos);
  EXPECT_NE(content_of(suite_ / "report.html").find("gone"), std::string::npos);
}

TEST_F(RegressCommand, AGoldenPictureOfAnotherRendererIsComparedAndReported) {
  accept_all();
  fs::rename(golden("").parent_path(), suite_ / "goldens" / "Some-Other-Card");
  const Outcome outcome = regress("");
  EXPECT_EQ(outcome.code, 0) << outcome.output;
  EXPECT_NE(content_of(suite_ / "report.html").find("Some-Other-Card"), std::string::npos);
}

TEST_F(RegressCommand, OnlyWhatIsNamedIsAccepted) {
  EXPECT_EQ(regress("--only wall_body_0009 --accept").code, 0);
  EXPECT_TRUE(fs::exists(golden("wall_body_0009.png")));
  EXPECT_FALSE(fs::exists(golden("wall_body_0000.png")));
}

TEST_F(RegressCommand, ADamagedGoldenPictureIsReportedAndAcceptedAgain) {
  accept_all();
  std::ofstream(golden("wall_body_0009.json")) << "<<<<<<< HEAD";
  fs::remove(golden("wall_body_0000.ids.png"));
  const Outcome outcome = regress("");
  EXPECT_EQ(outcome.code, 1);
  EXPECT_NE(outcome.output.find("missing_golden: wall_body_0009: The golden picture cannot be read"), std::string::npos)
      << outcome.output;
  EXPECT_NE(outcome.output.find("failed: wall_body_0000: "), std::string::npos) << outcome.output;
  accept_all();
  EXPECT_EQ(regress("").code, 0);
}

TEST_F(RegressCommand, AJobThatTakesTooLongIsAnError) {
  std::ofstream(suite_ / "suite.json")
      << R"({"pictures": [{"name": "wall", "scene": "wall.json", "frames": 1000000}]})";
  const Outcome outcome = regress("--time-limit 1");
  EXPECT_EQ(outcome.code, 1);
  EXPECT_NE(outcome.output.find("error: wall: took more than 1 s"), std::string::npos) << outcome.output;
}

TEST_F(RegressCommand, ASuiteIsMadeOfScenesOnce) {
  const fs::path made = test_folder() / "made";
  fs::remove_all(made);
  const std::string command = "regress " + made.string() + " --init '" + (suite_ / "wall.json").string() + "'";
  const Outcome outcome = run_program(command);
  EXPECT_EQ(outcome.code, 0) << outcome.output;
  EXPECT_EQ(run_program("regress " + made.string()).code, 0);
  for (const RenderJob& job : suite_jobs(made, {})) {
    EXPECT_EQ(job.width, 640);
    EXPECT_EQ(job.height, 360);
    EXPECT_EQ(std::ranges::count(job.views, "utilization"), 0) << "debris without load is of one color";
  }
  EXPECT_EQ(run_program(command).code, 2);
  EXPECT_EQ(run_program("regress " + (test_folder() / "none").string()).code, 2);
}

TEST_F(RegressCommand, ShardsAreAllOfTheSuiteAndNothingTwice) {
  const std::vector<RenderJob> all = suite_jobs(suite_, {});
  for (const int count : {1, 2, 3, 5}) {
    std::multiset<std::string> names;
    for (int index = 1; index <= count; ++index)
      for (const RenderJob& job : suite_jobs(suite_, {index, count})) names.insert(job.name);
    EXPECT_EQ(names.size(), all.size());
    for (const RenderJob& job : all) EXPECT_EQ(names.count(job.name), 1u);
  }
  for (const char* text : {"0/3", "4/3", "1", "1/", "a/b", "1/3x", "-1/2"})
    EXPECT_THROW(shard_from_text(text), InputError) << text;
}

}  // namespace
}  // namespace griffith::app
