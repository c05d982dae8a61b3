#include "app/editor/scene_gallery.h"

#include <gmock/gmock.h>

#include <chrono>
#include <fstream>
#include <thread>

#include "app/shared/scene_files.h"
#include "app/shared/shipped_thumbnails.h"
#include "editor_fixture.h"
#include "sim/core/error.h"
#include "sim/scene/scene_writer.h"

namespace griffith::app {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

ThumbnailSource source() { return {GRIFFITH_PROGRAM, test_folder() / "thumbnails"}; }

/// Folder with a scene and a file that holds none.
fs::path folder_of_two() {
  fs::remove_all(test_folder());
  small_wall_file();
  test_file("notes.json", "no scene");
  return test_folder();
}

/// All that come within a minute.
std::vector<ThumbnailMaker::Made> wait_for_all(ThumbnailMaker& maker) {
  std::vector<ThumbnailMaker::Made> all;
  for (int i = 0; i < 6000 && !maker.done(); ++i) {
    while (std::optional<ThumbnailMaker::Made> made = maker.take()) all.push_back(std::move(*made));
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  EXPECT_TRUE(maker.done());
  return all;
}

TEST(ThumbnailMaker, APictureIsDrawnOnceAndKept) {
  const std::vector<fs::path> scenes = scenes_in(folder_of_two());
  ASSERT_EQ(scenes.size(), 2u);
  ThumbnailMaker first(scenes, source());
  const std::vector<ThumbnailMaker::Made> drawn = wait_for_all(first);
  ASSERT_EQ(drawn.size(), 1u) << "of the file that holds no scene there is none";
  EXPECT_EQ(scenes[drawn[0].scene].filename(), "small_wall.json");
  EXPECT_EQ(drawn[0].picture.width, 480);
  EXPECT_EQ(drawn[0].picture.height, 270);
  ThumbnailMaker second(scenes, {"", source().folder});  // has no program to draw with
  const std::vector<ThumbnailMaker::Made> kept = wait_for_all(second);
  ASSERT_EQ(kept.size(), 1u);
  EXPECT_EQ(kept[0].picture, drawn[0].picture);
}

TEST(ThumbnailMaker, AnEditedSceneHasAnotherPicture) {
  fs::remove_all(test_folder());
  const fs::path file = small_wall_file(), before = thumbnail_entry("folder", file);
  EXPECT_EQ(thumbnail_entry("folder", file), before);
  Scene edited = small_wall();
  edited.bodies[0].material.density += 1;
  write_scene(edited, file);
  EXPECT_NE(thumbnail_entry("folder", file), before);
  EXPECT_THROW(thumbnail_entry("folder", test_folder() / "none.json"), InputError);
}

TEST(ThumbnailMaker, ADamagedPictureIsDrawnAgain) {
  fs::remove_all(test_folder());
  const fs::path file = small_wall_file(), entry = thumbnail_entry(source().folder, file);
  fs::create_directories(entry.parent_path());
  std::ofstream(entry) << "no PNG";
  ThumbnailMaker maker({file}, source());
  EXPECT_EQ(wait_for_all(maker).size(), 1u);
}

TEST(ThumbnailMaker, WhoLeavesDoesNotWaitForPictures) {
  fs::remove_all(test_folder());
  const fs::path forever = test_folder() / "program";
  std::ofstream(forever) << "#!/bin/sh\nsleep 100\n";
  fs::permissions(forever, fs::perms::owner_all);
  const auto start = std::chrono::steady_clock::now();
  {
    ThumbnailMaker maker({small_wall_file()}, {forever, test_folder() / "thumbnails"});
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
    EXPECT_FALSE(maker.done());
  }
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(10));
}

TEST(ShippedThumbnails, AreShownAtOnceUntilTheirSceneIsEdited) {
  fs::remove_all(test_folder());
  const fs::path file = small_wall_file();
  EXPECT_FALSE(shipped_thumbnail(file));
  render::Image picture{kThumbnailWidth, kThumbnailHeight, {}};
  picture.rgba.assign(std::size_t{4} * kThumbnailWidth * kThumbnailHeight, 200);
  ship_thumbnail(file, picture);
  ThumbnailMaker maker({file}, {"", ""});  // can neither draw nor keep
  const std::vector<ThumbnailMaker::Made> made = wait_for_all(maker);
  ASSERT_EQ(made.size(), 1u);
  EXPECT_EQ(made[0].picture.width, kThumbnailWidth);
  EXPECT_NEAR(made[0].picture.pixel(100, 100)[0], 200, 3);
  EXPECT_THAT(stale_thumbnails(file.parent_path()), ::testing::IsEmpty());
  const fs::path before = shipped_thumbnail_file(file);
  Scene edited = small_wall();
  edited.bodies[0].material.density += 1;
  write_scene(edited, file);
  EXPECT_FALSE(shipped_thumbnail(file)) << "it shows another scene";
  EXPECT_THAT(stale_thumbnails(file.parent_path()), ::testing::ElementsAre(before));
  std::ofstream(before.parent_path() / "small_wall.mine.jpg") << "of the user";
  ship_thumbnail(file, picture);
  EXPECT_TRUE(shipped_thumbnail(file));
  EXPECT_FALSE(fs::exists(before));
  EXPECT_TRUE(fs::exists(before.parent_path() / "small_wall.mine.jpg"));
}

TEST(ShippedThumbnails, WhatIsNoSmallPictureIsNone) {
  fs::remove_all(test_folder());
  const fs::path file = small_wall_file();
  render::Image large{kThumbnailWidth + 1, 2, {}};
  large.rgba.assign(std::size_t{8} * static_cast<std::size_t>(large.width), 90);
  ship_thumbnail(file, large);
  EXPECT_FALSE(shipped_thumbnail(file));
  std::ofstream(shipped_thumbnail_file(file)) << "no picture";
  EXPECT_FALSE(shipped_thumbnail(file));
}

TEST(ShippedThumbnails, EachShippedSceneHasOneOfItAsItIs) {
  for (const char* name : {"scenes", "scenes/validation"}) {
    const fs::path folder = fs::path(GRIFFITH_SOURCE_DIR) / name;
    EXPECT_GT(scenes_in(folder).size(), 5u);
    std::vector<fs::path> without = scenes_in(folder);
    std::erase_if(without, [](const fs::path& scene) { return shipped_thumbnail(scene).has_value(); });
    EXPECT_THAT(without, ::testing::IsEmpty())
        << "these have no thumbnail, or one from before they were edited: griffith thumbnail --ship " << folder;
    EXPECT_THAT(stale_thumbnails(folder), ::testing::IsEmpty()) << "of scenes that are gone: remove them";
  }
}

TEST(ShippedThumbnails, ACommandDrawsThoseThatAreMissing) {
  fs::remove_all(test_folder());
  const fs::path file = small_wall_file();
  const Outcome first = run_program("thumbnail --ship " + file.string());
  EXPECT_EQ(first.code, 0) << first.output;
  EXPECT_THAT(first.output, HasSubstr(shipped_thumbnail_file(file).string()));
  ASSERT_TRUE(shipped_thumbnail(file));
  EXPECT_EQ(run_program("thumbnail --ship " + file.string()).output, "") << "all are there";
  EXPECT_EQ(run_program("thumbnail " + file.string()).code, 2) << "where to?";
}

TEST(SceneCard, ReportsWhatAFileHoldsOrWhatIsWrongWithIt) {
  folder_of_two();
  const ui::SceneCard wall = scene_card(small_wall_file()), notes = scene_card(test_folder() / "notes.json");
  EXPECT_EQ(wall.title, "small wall");
  EXPECT_EQ(wall.topic, "Impact on supported bodies");
  EXPECT_TRUE(wall.readable);
  EXPECT_EQ(notes.title, "notes");
  EXPECT_FALSE(notes.readable);
  EXPECT_THAT(notes.description, HasSubstr("notes.json"));
}

class SceneBrowsing : public EditorTest {
 protected:
  SceneBrowsing() {
    folder_of_two();
    editor_.builder().open(small_wall_file());
    draw(2);
  }
};

TEST_F(SceneBrowsing, ShowsScenesBesideTheOpenOneAndThenTheirPictures) {
  editor_.scenes().show_thumbnails(source());
  press_key('O', true, true);
  draw(6);
  EXPECT_EQ(value("scenes/small_wall"), "small wall");
  EXPECT_EQ(value("scenes/notes"), "notes");
  type("small");
  draw(3);
  EXPECT_EQ(value("scenes/small_wall"), "small wall");
  EXPECT_EQ(value("scenes/notes"), "no widget scenes/notes");
}

TEST_F(SceneBrowsing, EditsAreAskedForBeforeAnotherSceneIsOpened) {
  Scene other = small_wall();
  other.name = "other";
  write_scene(other, test_folder() / "other.json");
  editor_.builder().open(small_wall_file());
  wait_for_work();
  choose_material("concrete");
  press_key('O', true, true);
  draw(3);
  type("other.json");
  press_key(ui::key::kEnter);
  draw(3);
  click("unsaved/discard");
  draw(2);
  EXPECT_EQ(editor_.document().scene().name, "other");
}

TEST(ThumbnailCommand, DrawsAPictureOfTheSceneAfterItCracked) {
  fs::remove_all(test_folder());
  const fs::path picture = test_folder() / "wall.png";
  const Outcome outcome = run_program("thumbnail " + small_wall_file().string() + " -o " + picture.string());
  EXPECT_EQ(outcome.code, 0) << outcome.output;
  EXPECT_EQ(render::load_png(picture).width, 480);
  EXPECT_EQ(run_program("thumbnail nowhere.json -o " + picture.string()).code, 2);
}

}  // namespace
}  // namespace griffith::app
