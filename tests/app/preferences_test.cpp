#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "app/editor/known_scenes.h"
#include "app/editor/preferences_file.h"
#include "editor_fixture.h"
#include "sim/core/read_file.h"
#include "tests/input_error_of.h"

namespace griffith::app {
namespace {

/// Without what an earlier run left.
std::filesystem::path emptied_folder() {
  std::filesystem::remove_all(test_folder());
  return test_folder();
}

using ::testing::ElementsAre;
using ::testing::HasSubstr;

TEST(Preferences, AreReadAsTheyWereKept) {
  const std::filesystem::path path = emptied_folder() / "config/griffith/preferences.json";
  EXPECT_EQ(PreferencesFile(path).read(), ui::Preferences());
  ui::Preferences mine;
  mine.ui_scale = 1.5, mine.autosave_interval = 30, mine.mouse_speed = 2;
  mine.invert_orbit = mine.invert_zoom = true;
  mine.left_width = 250, mine.right_width = 400;
  mine.plotted = {"pieces", "", "energy.heat"};
  mine.logarithmic_plots = true;
  mine.past_memory = 2048;
  mine.show_left = false;
  mine.log_height = 333;
  ui::move_section(mine.sections, "inspector", true, "outliner");
  mine.sections.folded = {"projectile", "view"};
  PreferencesFile(path).keep(mine);
  EXPECT_EQ(PreferencesFile(path).read(), mine);
}

TEST(Preferences, AreWrittenOnlyWhereTheyChanged) {
  const std::filesystem::path path = emptied_folder() / "preferences.json";
  PreferencesFile file(path);
  file.keep({});
  EXPECT_FALSE(std::filesystem::exists(path));
  ui::Preferences larger;
  larger.ui_scale = 2;
  file.keep(larger);
  std::filesystem::remove(path);
  file.keep(larger);
  EXPECT_FALSE(std::filesystem::exists(path));
}

std::string problem_of_preferences(const std::string& text) {
  return input_error_of([&] { PreferencesFile(test_file("preferences.json", text)).read(); });
}

TEST(Preferences, DamagedFilesAreReported) {
  EXPECT_THAT(problem_of_preferences("{\"ui_scale\": "), HasSubstr("holds no preferences"));
  EXPECT_THAT(problem_of_preferences(""), HasSubstr("delete it"));
  EXPECT_THAT(problem_of_preferences("{\"ui_scale\": 40}"), HasSubstr("#/ui_scale: is 40"));
  EXPECT_THAT(problem_of_preferences("{\"ui_scale\": \"big\"}"), HasSubstr("from 0.75 to 3"));
  EXPECT_THAT(problem_of_preferences("{\"invert_zoom\": 1}"), HasSubstr("true or false"));
  EXPECT_THAT(problem_of_preferences("{\"plotted\": [\"pieces\"]}"), HasSubstr("6 names of series"));
  EXPECT_THAT(problem_of_preferences("{\"sections\": {\"left\": [\"view\"]}}"), HasSubstr("lists \"left\", \"right\""));
  EXPECT_THAT(problem_of_preferences(R"({"sections": {"left": ["view"], "right": [], "folded": []}})"),
              HasSubstr("each section on one side"));
  EXPECT_EQ(problem_of_preferences("{\"of a later version\": 1}"), "no error");
}

TEST(RecentFiles, TheNewestIsFirstOnceAndWhatIsGoneIsPassedBy) {
  RecentFiles recent(emptied_folder());
  const std::filesystem::path a = test_file("a.json", "{}"), b = test_file("b.json", "{}");
  recent.add(a);
  recent.add(b);
  recent.add(a);
  EXPECT_THAT(recent.files(), ElementsAre(a, b));
  EXPECT_THAT(RecentFiles(test_folder()).files(), ElementsAre(a, b));
  std::filesystem::remove(a);
  EXPECT_THAT(RecentFiles(test_folder()).files(), ElementsAre(b));
  for (int i = 0; i < 20; ++i) recent.add(test_file(std::to_string(i) + ".json", "{}"));
  EXPECT_EQ(recent.files().size(), RecentFiles::kMost);
}

TEST_F(EditorTest, OpenedScenesAreInTheMenuOfRecentOnes) {
  editor_.enable_autosave(test_folder() / "states");
  editor_.builder().open(small_wall_file());
  wait_for_work();
  click("menu/File");
  click("menu/Recent");
  draw(4);
  EXPECT_EQ(value("menu/recent/small_wall"), "small_wall");
}

TEST_F(EditorTest, PreferencesAreChangedInTheirDialog) {
  editor_.execute({.name = "edit.preferences"});
  draw(4);
  click("preferences/invert_orbit");
  EXPECT_TRUE(editor_.state().preferences.invert_orbit);
  click("preferences/mouse_speed", 1);
  type("2");
  press_key(ui::key::kEnter);
  EXPECT_EQ(editor_.state().preferences.mouse_speed, 2);
  click("preferences/defaults");
  EXPECT_EQ(editor_.state().preferences, ui::Preferences());
  click("preferences/close");
  EXPECT_FALSE(editor_.state().show_preferences);
}

}  // namespace
}  // namespace griffith::app
