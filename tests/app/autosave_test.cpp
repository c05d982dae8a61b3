// Copies of edits that are not saved, in folders that others may write to.

#include "app/editor/autosave.h"

#include <gmock/gmock.h>

#include <fstream>

#include "program.h"
#include "sim/core/error.h"
#include "sim/core/read_file.h"
#include "sim/scene/scene_reader.h"

namespace griffith::app {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

/// A folder of the user's that holds a scene and more, elsewhere than the scene that is opened.
fs::path folder_of_the_users() {
  const fs::path folder = test_folder() / "users";
  fs::create_directories(folder);
  fs::copy_file(small_wall_file(), folder / "scene.json", fs::copy_options::overwrite_existing);
  std::ofstream(folder / "notes.txt") << "a year's work";
  return folder;
}

TEST(Autosave, LinksBesideASceneAreNotFollowed) {
  const fs::path users = folder_of_the_users(), file = small_wall_file();
  for (const char* name : {".small_wall.json.edits-a1b2c3", ".small_wall.json.edits-", ".small_wall.json.edits-a"}) {
    const fs::path link = file.parent_path() / name;
    fs::create_directory_symlink(users, link);
    Autosave autosave(test_folder() / "states");
    EXPECT_FALSE(autosave.find(file)) << name;
    EXPECT_FALSE(autosave.find_any(file)) << name;
    EXPECT_TRUE(fs::is_symlink(link)) << name;
    fs::remove(link);
  }
  EXPECT_TRUE(fs::exists(users / "notes.txt"));
}

TEST(Autosave, LinksAmongTheStatesLeadToCopiesAlone) {
  const fs::path states = test_folder() / "states", users = folder_of_the_users();
  fs::create_directories(states);
  fs::create_directory_symlink(users, states / "edits-a1b2c3");
  Autosave autosave(states);
  EXPECT_FALSE(autosave.find_any(""));
  EXPECT_TRUE(fs::exists(users / "scene.json"));
  EXPECT_TRUE(fs::exists(users / "notes.txt"));
}

TEST(Autosave, DiscardingRemovesWhatTheProgramWroteAlone) {
  const fs::path file = small_wall_file(), copy = file.parent_path() / ".small_wall.json.edits-a1b2c3";
  fs::remove_all(copy);
  fs::create_directories(copy);
  fs::copy_file(file, copy / "scene.json");
  std::ofstream(copy / "notes.txt") << "a year's work";
  Autosave autosave(test_folder() / "states");
  ASSERT_TRUE(autosave.find(file));
  autosave.remove_found();
  EXPECT_FALSE(fs::exists(copy / "scene.json"));
  EXPECT_EQ(read_file(copy / "notes.txt"), "a year's work");
  EXPECT_FALSE(autosave.find(file));
}

TEST(Autosave, ACopyNeitherReadsNorWritesThroughALink) {
  const fs::path users = folder_of_the_users(), file = small_wall_file();
  const fs::path copy = file.parent_path() / ".small_wall.json.edits-a1b2c3";
  fs::remove_all(copy);
  fs::create_directories(copy);
  fs::create_symlink(users / "scene.json", copy / "scene.json");
  EXPECT_FALSE(Autosave(test_folder() / "states").find(file));
}

TEST(Autosave, TheNameOfACopyReportsWhoseItIs) {
  const fs::path file = small_wall_file(), copy = file.parent_path() / ".small_wall.json.edits-a1b2c3";
  fs::remove_all(copy);
  fs::create_directories(copy);
  fs::copy_file(file, copy / "scene.json");
  std::ofstream(copy / "origin") << "../../elsewhere/thesis.json";
  Autosave autosave(test_folder() / "states");
  ASSERT_TRUE(autosave.find(file));
  EXPECT_EQ(autosave.found_edits().file, file) << "a save goes nowhere else";
  autosave.remove_found();
  EXPECT_FALSE(fs::exists(copy));
}

TEST(Autosave, ACopyThatCannotBeReadIsReportedAndStays) {
  const fs::path states = test_folder() / "states";
  fs::remove_all(states);
  Autosave(states).write(small_wall(), "");
  Autosave reader(states);
  for (const auto& entry : fs::directory_iterator(states)) std::ofstream(entry.path() / "scene.json") << "{";
  ASSERT_TRUE(reader.find_any(""));
  EXPECT_THROW(reader.found_edits(), InputError);
  reader.leave_found();
  EXPECT_TRUE(Autosave(states).find_any(""));
}

TEST(Autosave, InstancesThatRunLeaveEachOthersCopiesAlone) {
  const fs::path states = test_folder() / "states", file = small_wall_file();
  fs::remove_all(states);
  Autosave second(states);
  {
    Autosave first(states);
    first.write(small_wall(), file);
    second.write(small_wall(), file);
    EXPECT_FALSE(Autosave(states).find(file)) << "both are still at work";
    second.remove();
    EXPECT_FALSE(second.find(file));
  }
  EXPECT_TRUE(second.find(file)) << "the first one is gone";
  EXPECT_FALSE(Autosave(states).find(file)) << "the second one asks about it";
  second.adopt_found();
  EXPECT_FALSE(Autosave(states).find(file));
  second.remove();
  EXPECT_FALSE(Autosave(states).find(file));
}

TEST(Autosave, ACopyWhoseFolderVanishedIsBegunAgain) {
  const fs::path states = test_folder() / "states", file = small_wall_file();
  fs::remove_all(states);
  {
    Autosave autosave(states);
    autosave.write(small_wall(), file);
    for (const auto& link : fs::directory_iterator(states)) fs::remove_all(fs::read_symlink(link));
    autosave.write(small_wall(), file);
  }
  Autosave reader(states);
  EXPECT_TRUE(reader.find_any(""));
  reader.remove_found();
}

TEST(Autosave, AFolderThatTakesNoCopyIsNamed) {
  Autosave autosave(test_folder() / "states");
  try {
    autosave.write(small_wall(), test_folder() / "nowhere/scene.json");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.where(), HasSubstr("nowhere"));
  }
  EXPECT_THROW(Autosave("").write(small_wall(), ""), InputError);
}

}  // namespace
}  // namespace griffith::app
