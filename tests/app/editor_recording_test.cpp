#include <gmock/gmock.h>

#include <fstream>

#include "editor_fixture.h"
#include "sim/recording/replay.h"

namespace griffith::app {
namespace {

using ::testing::HasSubstr;

class EditorRecording : public EditorTest {
 protected:
  void make_steps(int count) {
    for (int i = 0; i < count; ++i) editor_.execute({.name = "simulation.step"});
    draw();
  }

  /// Shoots, weakens the material, goes back and shoots otherwise: two branches.
  void play() {
    make_steps(4);
    editor_.execute({.name = "simulation.fire", .cursor = Vec2(0.5, 0.5)});
    choose_material("granite");
    make_steps(6);
    editor_.execute({.name = "time.step", .step = 7});
    editor_.execute({.name = "simulation.fire", .cursor = Vec2(0.4, 0.4)});
    make_steps(4);
    editor_.execute({.name = "time.step", .step = 2});
    draw();
  }

  std::filesystem::path path(const std::string& name) const {
    const auto file = test_folder() / name;
    std::filesystem::remove(file);
    return file;
  }
};

void expect_equal_replay(const Recording& recording) {
  Replay replay(recording);
  while (!replay.at_end()) replay.advance();
  EXPECT_FALSE(replay.difference()) << "step " << replay.difference()->step << " "
                                    << replay.difference()->fields.front();
}

TEST_F(EditorRecording, WhatWasPlayedReplaysWithoutTheEditor) {
  play();
  editor_.execute({.name = "file.write_recording", .path = path("run.tar.zst")});
  const Recording recording = read_recording(test_folder() / "run.tar.zst");
  EXPECT_EQ(recording.steps(), 11);
  EXPECT_EQ(recording.inputs.size(), 3u);
  expect_equal_replay(recording);
  EXPECT_EQ(run_program("replay " + (test_folder() / "run.tar.zst").string()).code, 0);
}

TEST_F(EditorRecording, TheMenuAsksForAFileOfItsOwnKind) {
  make_steps(2);
  click("menu/File");
  click("menu/file.record");
  draw(3);
  ASSERT_TRUE(editor_.state().save_as);
  EXPECT_EQ(editor_.state().save_as->kind, ui::SavedKind::recording);
  EXPECT_THAT(value("save/path"), HasSubstr(".tar.zst"));
  click("save/cancel");
  EXPECT_FALSE(editor_.state().save_as);
}

TEST_F(EditorRecording, NoFileIsReplacedUnasked) {
  make_steps(1);
  const auto file = path("run.tar.zst");
  std::ofstream(file) << "mine";
  editor_.execute({.name = "file.write_recording", .path = file});
  ASSERT_TRUE(editor_.state().replacement);
  draw(3);
  click("replace/replace");
  EXPECT_EQ(read_recording(file).steps(), 1);
}

TEST_F(EditorRecording, ABugReportHoldsTheWindowAndTheLog) {
  play();
  const auto file = path("report.tar.zst");
  log_message(editor_.state(), ui::LogLevel::warning, "something odd");
  editor_.execute({.name = "help.write_report", .path = file});
  const auto request = editor_.files().take_picture_request();
  ASSERT_TRUE(request);
  EXPECT_FALSE(editor_.files().take_picture_request()) << "once";
  draw();
  editor_.files().save_window_picture(*request, window_image(), editor_.tags(), "a test");
  const Recording report = read_recording(file);
  EXPECT_THAT(report.extras.at("log.txt"), HasSubstr("warning: something odd"));
  EXPECT_TRUE(report.extras.at("screenshot.png").starts_with("\x89PNG"));
  EXPECT_EQ(version_of(report.versions, "graphics"), "a test");
  expect_equal_replay(report);
}

TEST_F(EditorRecording, WhatCannotBeWrittenIsShown) {
  editor_.execute({.name = "file.write_recording", .path = "/nowhere/run.tar.zst"});
  ASSERT_TRUE(editor_.state().error);
  EXPECT_EQ(editor_.state().error->where, "/nowhere/run.tar.zst");
}

TEST_F(EditorRecording, AFileThatChangedSinceIsNoLongerWhatRan) {
  std::filesystem::copy_file(std::string(GRIFFITH_SOURCE_DIR) + "/scenes/meshes/voussoir.msh", path("mesh.msh"));
  Scene scene = small_wall();
  scene.bodies[0].shape = MeshFileShape{test_folder() / "mesh.msh"};
  scene.bodies[0].supports.clear();
  Editor editor(scene, "");
  editor.execute({.name = "simulation.step"});
  editor.execute({.name = "file.write_recording", .path = path("run.tar.zst")});
  EXPECT_FALSE(editor.state().error);
  const auto later = std::filesystem::file_time_type::clock::now() + std::chrono::seconds(2);
  std::filesystem::last_write_time(test_folder() / "mesh.msh", later);
  editor.execute({.name = "file.write_recording", .path = path("run.tar.zst")});
  ASSERT_TRUE(editor.state().error);
  EXPECT_THAT(editor.state().error->problem, HasSubstr("has changed"));
}

}  // namespace
}  // namespace griffith::app
