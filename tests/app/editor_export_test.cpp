#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>

#include "editor_fixture.h"
#include "renderer/image.h"
#include "sim/core/replace_file.h"

namespace griffith::app {
namespace {

using ::testing::HasSubstr;
namespace fs = std::filesystem;

class ExportTest : public EditorTest {
 protected:
  ExportTest() { fs::remove_all(test_folder()), fs::create_directories(test_folder()); }

  void run(int steps) {
    for (int i = 0; i < steps; ++i) editor_.run().step();
    draw();
  }
  void write(const fs::path& file) { editor_.execute({.name = "file.write_export", .path = file}); }
  static std::string beginning(const fs::path& file, std::size_t count) {
    std::string text(count, ' ');
    std::ifstream(file, std::ios::binary).read(text.data(), static_cast<std::streamsize>(count));
    return text;
  }
};

TEST_F(ExportTest, TheDialogProposesAFileForOtherPrograms) {
  EXPECT_FALSE(editor_.disabled_reason("file.export").empty()) << "there is no past yet";
  run(5);
  const std::uint64_t hash = editor_.run().timeline().world().state_hash();
  press_key('E', true);
  draw(3);
  EXPECT_THAT(value("save/path"), HasSubstr("small wall.glb"));
  press_key(ui::key::kEscape);
  const fs::path file = test_folder() / "run";
  editor_.state().save_as = ui::save_target(file, ui::SavedKind::exported);
  draw(3);
  click("save/save");
  EXPECT_FALSE(editor_.state().work.empty());
  wait_for_work();
  EXPECT_EQ(beginning(file.string() + ".glb", 4), "glTF");
  EXPECT_THAT(editor_.state().log.back().text, HasSubstr("run.glb: 6 frames"));
  EXPECT_EQ(editor_.run().timeline().world().state_hash(), hash) << "what is shown stays";
}

TEST_F(ExportTest, TheWindowLeavesTheProcessorsToWhatGoesOnBesideIt) {
  run(5);
  write(test_folder() / "run.glb");
  EXPECT_GE(editor_.seconds_to_next_frame(), 0.05);
  wait_for_work();
  write(test_folder() / "wall.png");
  EXPECT_EQ(editor_.seconds_to_next_frame(), 0) << "each frame draws a picture";
  wait_for_work();
  EXPECT_GT(editor_.seconds_to_next_frame(), 1);
}

TEST_F(ExportTest, PicturesAreNumberedByTheirSteps) {
  run(3);
  write(test_folder() / "wall.png");
  wait_for_work();
  for (const char* name : {"wall_0000.png", "wall_0001.png", "wall_0002.png", "wall_0003.png"}) {
    ASSERT_TRUE(fs::exists(test_folder() / name)) << name;
    const render::Image image = render::load_png(test_folder() / name);
    EXPECT_NEAR(image.width, editor_.state().viewport_size.x, 1);
    EXPECT_NEAR(image.height, editor_.state().viewport_size.y, 1);
  }
  EXPECT_NE(render::load_png(test_folder() / "wall_0000.png"), render::load_png(test_folder() / "wall_0003.png"));
  EXPECT_FALSE(fs::exists(test_folder() / "wall_0004.png"));
}

TEST_F(ExportTest, PicturesOfOthersAreNotReplacedUnasked) {
  run(2);
  replace_file(test_folder() / "wall_0001.png", "not mine");
  write(test_folder() / "wall.png");
  draw(2);
  ASSERT_TRUE(editor_.state().replacement);
  EXPECT_THAT(editor_.state().replacement->problem, HasSubstr("wall_0001.png already exists"));
  EXPECT_EQ(beginning(test_folder() / "wall_0001.png", 8), "not mine");
  EXPECT_TRUE(editor_.state().work.empty());
}

TEST_F(ExportTest, ACancelledOneReportsThePicturesThatAreThere) {
  run(5);
  write(test_folder() / "wall.png");
  draw(2);
  editor_.state().cancel_work = true;
  wait_for_work();
  EXPECT_TRUE(fs::exists(test_folder() / "wall_0000.png"));
  EXPECT_THAT(editor_.state().log.back().text, HasSubstr("cancelled: wrote "));
}

TEST_F(ExportTest, AVideoOfTheView) {
  if (std::system("ffmpeg -version >/dev/null 2>&1") != 0) GTEST_SKIP() << "ffmpeg is not installed";
  run(4);
  write(test_folder() / "wall.mp4");
  wait_for_work();
  EXPECT_EQ(beginning(test_folder() / "wall.mp4", 8).substr(4), "ftyp");
}

TEST_F(ExportTest, CancelLeavesNoFile) {
  run(300);
  for (const char* name : {"run.glb", "run.json"}) {
    write(test_folder() / name);
    editor_.state().cancel_work = true;
    wait_for_work();
    EXPECT_FALSE(fs::exists(test_folder() / name));
    EXPECT_THAT(editor_.state().log.back().text, HasSubstr("cancelled"));
  }
}

TEST_F(ExportTest, WhatCannotBeWrittenIsReportedBefore) {
  run(2);
  write(test_folder() / "run.xyz");
  draw(2);
  ASSERT_TRUE(editor_.state().error);
  EXPECT_THAT(editor_.state().error->remedy, HasSubstr(".glb"));
  EXPECT_TRUE(editor_.state().work.empty());
  editor_.state().error.reset();
  write("/nowhere/run.glb");
  draw(2);
  ASSERT_TRUE(editor_.state().error);
  EXPECT_THAT(editor_.state().error->where, HasSubstr("/nowhere"));
}

}  // namespace
}  // namespace griffith::app
