// What is known to be wrong with the edited scene, and the way to its fields.

#include <gmock/gmock.h>

#include "editor_fixture.h"
#include "sim/scene/scene_writer.h"
#include "ui/model/entry_choice.h"

namespace griffith::app {
namespace {

using ::testing::HasSubstr;

/// A wall with a load on nothing, and a block that starts inside it.
Scene faulty() {
  Scene scene = small_wall();
  Load load;
  load.region = BoxRegion{Vec3(50, 50, 50), Vec3(51, 51, 51)};
  scene.bodies[0].loads = {load};
  BodyDescription block;
  block.name = "block";
  block.shape = BoxShape{Vec3::Constant(0.5), Vec3::Constant(0.25), BoxPattern::five_tet};
  block.position = Vec3(0, 1, 0);
  scene.bodies.push_back(block);
  return scene;
}

class EditorProblems : public EditorTest {
 protected:
  explicit EditorProblems(const Scene& scene = faulty()) : EditorTest(scene) {}

  /// Returns the row of the list with that text.
  std::string row_with(const std::string& text) {
    for (const ui::WidgetTag& tag : editor_.tags())
      if (tag.name.starts_with("problems/") && tag.value.find(text) != std::string::npos) return tag.name;
    return "no row with " + text;
  }
};

TEST_F(EditorProblems, TheStatusBarCountsThemAndOpensTheList) {
  EXPECT_EQ(value("status/problems"), "2 problems");
  EXPECT_EQ(value("problems/0"), "no widget problems/0");
  click("status/problems");
  draw(2);
  EXPECT_THAT(value(row_with("holds no")), HasSubstr("Load 1 of wall: region"));
  EXPECT_THAT(value(row_with("inside")), HasSubstr("block: position"));
  click("problems/close");
  draw(2);
  EXPECT_EQ(value("problems/0"), "no widget problems/0");
}

TEST_F(EditorProblems, TheListIsWhatCheckSays) {
  write_scene(faulty(), test_folder() / "faulty.json");
  const std::string checked = run_program("check " + (test_folder() / "faulty.json").string()).output;
  click("status/problems");
  draw(2);
  for (const char* row : {"problems/0", "problems/1"}) {
    const std::string shown = value(row), text = shown.substr(shown.find(": ", shown.find(": ") + 1) + 2);
    EXPECT_THAT(checked, HasSubstr(text));
  }
}

TEST_F(EditorProblems, AClickChoosesTheEntryAndShowsItsField) {
  click("status/problems");
  draw(2);
  click(row_with("holds no"));
  draw(6);
  EXPECT_EQ(ui::active_entry(editor_.state(), editor_.document().scene()), (ui::SceneEntry{ui::EntryKind::load, 0, 0}));
  EXPECT_EQ(value("entry/region"), "open");
  EXPECT_THAT(value("field_note"), HasSubstr("holds no"));
  EXPECT_THAT(editor_.state().field_note.tag, HasSubstr("entry/region"));
}

TEST_F(EditorProblems, AFieldOfABodyIsUnfoldedAndScrolledTo) {
  click("status/problems");
  draw(2);
  EXPECT_EQ(value("body"), "closed");
  click(row_with("inside"));
  draw(6);
  EXPECT_EQ(editor_.state().selected_body, 1);
  EXPECT_EQ(value("body"), "open");
  const ui::WidgetTag* field = ui::find_tag(editor_.tags(), "body/position/0");
  ASSERT_NE(field, nullptr);
  EXPECT_GE(field->minimum.y, 0);
  EXPECT_LT(field->maximum.y, static_cast<float>(target_.height()));
  EXPECT_THAT(value("field_note"), HasSubstr("move them apart"));
}

TEST_F(EditorProblems, TheListFollowsEditsAndUndo) {
  set_values(editor_.document().history(), editor_.state(),
             std::vector<SceneSetting>{{"/bodies/1/position", "[5, 1, 0]"}}, "test");
  draw(2);
  wait_for_work();
  EXPECT_EQ(value("status/problems"), "1 problem");
  editor_.execute({.name = "edit.undo"});
  draw(2);
  wait_for_work();
  EXPECT_EQ(value("status/problems"), "2 problems");
}

TEST_F(EditorProblems, ANewSceneHasNone) {
  ASSERT_EQ(value("status/problems"), "2 problems");
  editor_.execute({.name = "file.new", .discard_edits = true});
  draw(2);
  EXPECT_EQ(value("status/problems"), "no widget status/problems");
}

TEST_F(EditorProblems, NamesThatAreOutdatedGoWhenTheSceneIsSaved) {
  editor_.builder().open(
      test_file("older.json", R"({"version": 1, "bodies": [{"shape": {"box": {}}, "position": [0, 0.5, 0]}],
      "view": {"quantity": "margin"}})"));
  wait_for_work();
  EXPECT_EQ(value("status/problems"), "1 problem");
  press_key('S', true);
  draw(2);
  EXPECT_EQ(value("status/problems"), "no widget status/problems");
}

TEST_F(EditorProblems, WhatBecameOfTheCellsOfAMeshIsListed) {
  test_file("pyramid.msh",
            "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n5\n1 0 0 0\n2 1 0 0\n3 1 1 0\n4 0 1 0\n5 0 0 1\n$EndNodes\n"
            "$Elements\n2\n1 7 2 1 1 1 2 3 4 5\n2 2 2 1 1 1 2 3\n$EndElements\n");
  editor_.builder().open(test_file("pyramid.json", R"({"version": 1, "bodies": [
      {"name": "pyramid", "shape": {"mesh": {"path": "pyramid.msh"}}, "position": [0, 1, 0]}]})"));
  wait_for_work();
  click("status/problems");
  draw(2);
  EXPECT_THAT(value(row_with("split")), HasSubstr("1 pyramid split into 2 tetrahedra"));
  EXPECT_THAT(value(row_with("skipped:")), HasSubstr("1 triangle skipped: no volume"));
}

}  // namespace
}  // namespace griffith::app
