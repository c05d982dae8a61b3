#include <gmock/gmock.h>

#include <fstream>

#include "app/editor/autosave.h"
#include "editor_fixture.h"
#include "sim/core/error.h"
#include "sim/scene/scene_reader.h"
#include "sim/scene/scene_writer.h"
#include "ui/dialogs/dialog_window.h"

namespace griffith::app {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

/// An editor whose scenes and states are in an empty folder of the test's own.
class EditorFiles : public EditorTest {
 protected:
  EditorFiles() {
    fs::remove_all(test_folder());
    fs::create_directories(states());
  }
  ~EditorFiles() override { fs::remove_all(test_folder()); }

  static fs::path states() { return test_folder() / "states"; }

  bool modified() const { return editor_.document().title().find('*') != std::string::npos; }

  /// Leaves a copy of edits as a program would that was killed.
  static void leave_edits(const Scene& scene, const fs::path& file) { Autosave(states()).write(scene, file); }

  static int copies_in(const fs::path& folder) {
    int count = 0;
    for (const auto& entry : fs::directory_iterator(folder))
      count += entry.path().filename().string().find("edits-") != std::string::npos;
    return count;
  }
};

std::string text_of(const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

TEST_F(EditorFiles, ASceneWithoutAFileAsksWhereItIsToBeSaved) {
  fs::remove("small wall.json");
  choose_material("concrete");
  press_key('S', true);
  draw(4);
  EXPECT_FALSE(fs::exists("small wall.json")) << "nothing is written unasked";
  EXPECT_EQ(value("save/name"), "small wall.json");
  const fs::path wanted = test_folder() / "mine";
  type(wanted.string());
  EXPECT_EQ(value("save/path"), wanted.string() + ".json");
  click("save/save");
  EXPECT_EQ(read_scene(wanted.string() + ".json").bodies[0].material.name, "concrete");
  EXPECT_FALSE(modified());
  choose_material("soda-lime glass");
  press_key('S', true);  // now it has a file
  EXPECT_FALSE(modified());
  EXPECT_EQ(ui::shown_dialog(editor_.state()), ui::Dialog::none);
}

TEST_F(EditorFiles, AFileThatCannotBeWrittenNamesNoScene) {
  editor_.execute({.name = "file.new"});
  wait_for_work();
  const std::string name = editor_.document().scene().name;
  editor_.execute({.name = "file.save", .path = test_folder() / "missing" / "other.json"});
  EXPECT_TRUE(editor_.state().error);
  EXPECT_EQ(editor_.document().scene().name, name);
  EXPECT_FALSE(editor_.document().history().modified());
}

TEST_F(EditorFiles, CommandsInAFolderThatWasRemovedReportIt) {
  const fs::path before = fs::current_path(), gone = test_folder() / "gone";
  fs::create_directories(gone);
  fs::current_path(gone);
  fs::remove(gone);
  editor_.execute({.name = "file.save", .path = "any.json"});
  fs::current_path(before);
  ASSERT_TRUE(editor_.state().error);
  EXPECT_EQ(editor_.state().error->where, "any.json");
  draw(2);
}

TEST_F(EditorFiles, ValuesFromTheCommandLineAreEditsThatAreNotSaved) {
  const Scene saved = small_wall();
  Scene changed = saved;
  changed.projectiles[0].speed = 3;
  Editor editor(saved, small_wall_file(), &changed);
  EXPECT_NE(editor.document().title().find('*'), std::string::npos) << editor.document().title();
  EXPECT_EQ(editor.run().timeline().world().scene().projectiles[0].speed, 3);
  editor.execute({.name = "file.quit"});
  EXPECT_FALSE(editor.requests().quit) << "edits would be lost";
  editor.execute({.name = "edit.undo"});
  EXPECT_EQ(editor.document().title().find('*'), std::string::npos) << editor.document().title();
}

TEST_F(EditorFiles, AnotherFileIsReplacedOnlyOnRequest) {
  const fs::path own = small_wall_file(), other = test_file("other.json", "not to be lost");
  editor_.builder().open(own);
  draw(2);
  choose_material("concrete");
  press_key('S', true, true);
  draw(4);
  EXPECT_EQ(value("save/name"), "small_wall.json");
  type("other.json");
  click("save/save");
  draw(4);
  EXPECT_THAT(value("replace/problem"), HasSubstr("other.json already exists"));
  click("replace/cancel");
  draw(4);
  EXPECT_EQ(text_of(other), "not to be lost");
  EXPECT_EQ(value("save/name"), "other.json") << "asks for another name";
  EXPECT_EQ(value("save/small_wall.json"), "small_wall.json") << "shows existing files";
  click("save/save");
  draw(4);
  click("replace/replace");
  EXPECT_EQ(read_scene(other).bodies[0].material.name, "concrete");
  EXPECT_NE(read_scene(own).bodies[0].material.name, "concrete");
}

TEST_F(EditorFiles, AFileThatAnotherProgramChangedIsNotReplacedUnasked) {
  const fs::path own = small_wall_file();
  editor_.builder().open(own);
  draw(2);
  choose_material("concrete");
  test_file("small_wall.json", "changed meanwhile");
  fs::last_write_time(own, fs::file_time_type::clock::now() + std::chrono::seconds(2));
  press_key('S', true);
  draw(4);
  EXPECT_THAT(value("replace/problem"), HasSubstr("changed by another program"));
  click("replace/cancel");
  EXPECT_EQ(text_of(own), "changed meanwhile");
  press_key('S', true);
  draw(4);
  click("replace/replace");
  EXPECT_EQ(read_scene(own).bodies[0].material.name, "concrete");
}

TEST_F(EditorFiles, EditsOfASceneWithoutAFileCanBeSavedBeforeQuitting) {
  choose_material("concrete");
  editor_.execute({.name = "file.quit"});
  draw(4);
  click("unsaved/save");
  draw(4);
  click("save/cancel");
  EXPECT_FALSE(editor_.requests().quit);
  EXPECT_TRUE(modified());
  editor_.execute({.name = "file.quit"});
  draw(4);
  click("unsaved/save");
  draw(4);
  type((test_folder() / "kept.json").string());
  click("save/save");
  EXPECT_TRUE(editor_.requests().quit);
  EXPECT_EQ(read_scene(test_folder() / "kept.json").bodies[0].material.name, "concrete");
}

TEST_F(EditorFiles, SavingKeepsTheSchemaAndMaterialsThatNoBodyHas) {
  const fs::path own = test_file("scene.json", R"({"$schema": "scene.schema.json", "version": 1,
      "materials": {"spare": {"density": 7}}, "bodies": [{"shape": {"box": {}}}]})");
  editor_.builder().open(own);
  draw(2);
  choose_material("concrete");
  press_key('S', true);
  EXPECT_FALSE(modified());
  EXPECT_THAT(text_of(own), HasSubstr("\"$schema\": \"scene.schema.json\""));
  EXPECT_EQ(read_scene(own).materials.at(0).density, 7);
}

/// Expects that the first body of a scene file names a surface, relative to the file.
void expect_relative(const fs::path& scene, const fs::path& surface) {
  const fs::path path = std::get<SurfaceShape>(read_scene(scene).bodies.at(0).shape).path;
  EXPECT_TRUE(path.is_relative()) << path;
  EXPECT_EQ((scene.parent_path() / path).lexically_normal(), surface);
}

TEST_F(EditorFiles, WhatWasAddedWithoutAFileIsNamedFromTheFolderOfTheScene) {
  const fs::path scenes = fs::path(GRIFFITH_SOURCE_DIR) / "scenes";
  fs::create_directories(test_folder() / "a/b");
  editor_.execute({.name = "file.new", .discard_edits = true});
  editor_.execute({.name = "add.vase"});
  draw();
  wait_for_work();
  const std::uint64_t hash = editor_.run().timeline().world().state_hash();
  for (const char* name : {"near.json", "a/b/far.json", "near.json"}) {
    const fs::path file = test_folder() / name;
    editor_.execute({.name = "file.save", .path = file, .replace = true});
    expect_relative(file, scenes / "meshes/vase.obj");
    draw();
    wait_for_work();
    EXPECT_EQ(editor_.run().timeline().world().state_hash(), hash);
  }
  editor_.builder().open(test_folder() / "a/b/far.json");
  wait_for_work();
  EXPECT_FALSE(editor_.state().error);
  EXPECT_EQ(editor_.run().timeline().world().state_hash(), hash);
}

TEST_F(EditorFiles, RecordingsHoldFilesFromElsewhereIfOneSaysSo) {
  editor_.execute({.name = "file.new", .discard_edits = true});
  editor_.execute({.name = "add.vase"});
  draw();
  wait_for_work();
  editor_.execute({.name = "file.save", .path = test_folder() / "vase.json"});
  editor_.builder().open(test_folder() / "vase.json");
  wait_for_work();
  const fs::path file = test_folder() / "vase.tar.zst";
  editor_.execute({.name = "file.write_recording", .path = file});
  ASSERT_TRUE(editor_.state().error);
  EXPECT_THAT(editor_.state().error->remedy, ::testing::HasSubstr("Pack files from outside the scene's folder"));
  EXPECT_FALSE(fs::exists(file));
  editor_.state().error.reset();
  editor_.execute({.name = "file.write_recording", .path = file, .pack_outside = true});
  EXPECT_FALSE(editor_.state().error);
  EXPECT_TRUE(fs::exists(file));
}

TEST_F(EditorFiles, EditsAreCopiedOnceAMinuteUntilTheyAreSaved) {
  const fs::path own = small_wall_file();
  editor_.builder().open(own);
  draw(2);
  editor_.enable_autosave(states());
  editor_.recovery().copy(0);
  EXPECT_EQ(copies_in(test_folder()), 0) << "nothing is edited";
  choose_material("concrete");
  editor_.recovery().copy(1);
  EXPECT_EQ(copies_in(test_folder()), 1);
  EXPECT_EQ(copies_in(states()), 1) << "by which it is found from anywhere";
  const auto copied_material = [] {
    for (const auto& entry : fs::directory_iterator(states()))
      if (entry.is_directory()) return read_scene(entry.path() / "scene.json").bodies[0].material.name;
    return std::string();
  };
  choose_material("soda-lime glass");
  editor_.recovery().copy(60);
  EXPECT_EQ(copied_material(), "concrete");
  editor_.recovery().copy(61);
  EXPECT_EQ(copied_material(), "soda-lime glass");
  EXPECT_NE(read_scene(own).bodies[0].material.name, "soda-lime glass") << "the scene's own file is left alone";
  press_key('S', true);
  EXPECT_EQ(copies_in(test_folder()) + copies_in(states()), 0);
}

TEST_F(EditorFiles, CopiesGoWithEditsThatAreNotWanted) {
  editor_.enable_autosave(states());
  choose_material("concrete");
  editor_.recovery().copy(1);
  EXPECT_EQ(copies_in(states()), 1);
  editor_.execute({.name = "edit.undo"});
  editor_.recovery().copy(2);
  EXPECT_EQ(copies_in(states()), 0);
  choose_material("soda-lime glass");
  editor_.recovery().copy(100);
  EXPECT_EQ(copies_in(states()), 1);
  editor_.execute({.name = "file.quit", .discard_edits = true});
  EXPECT_EQ(copies_in(states()), 0);
}

TEST_F(EditorFiles, WhatACrashLeftIsRecoveredAndCanBeUndone) {
  const fs::path own = small_wall_file();
  test_file("tet.off", "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n");
  Scene edited = read_scene(own);
  edited.bodies[0].material.name = "mine";
  edited.projectiles[0].shape = SurfaceProjectile{"tet.off", 1};
  leave_edits(edited, own);
  editor_.enable_autosave(states());
  draw(4);
  EXPECT_THAT(value("left_edits/text"), HasSubstr("small_wall.json"));
  click("left_edits/recover");
  wait_for_work();
  EXPECT_FALSE(editor_.state().error);
  EXPECT_EQ(editor_.run().frame().materials[0].name, "mine");
  EXPECT_TRUE(modified());
  press_key('S', true);
  draw(4);
  EXPECT_THAT(value("replace/problem"), HasSubstr("may be newer"));
  click("replace/replace");
  EXPECT_EQ(read_scene(own).bodies[0].material.name, "mine");
  EXPECT_EQ(std::get<SurfaceProjectile>(*read_scene(own).projectiles[0].shape).path, "tet.off");
  EXPECT_EQ(copies_in(test_folder()) + copies_in(states()), 0);
  press_key('Z', true);
  EXPECT_NE(editor_.run().frame().materials[0].name, "mine");
}

TEST_F(EditorFiles, WhatACrashLeftCanBeKeptOrDiscarded) {
  Scene edited = small_wall();
  edited.name = "never saved";
  leave_edits(edited, "");
  editor_.enable_autosave(states());
  draw(4);
  EXPECT_THAT(value("left_edits/text"), HasSubstr("a new scene"));
  click("left_edits/later");
  EXPECT_EQ(copies_in(states()), 1);
  editor_.enable_autosave(states());
  draw(4);
  click("left_edits/discard");
  EXPECT_EQ(copies_in(states()), 0);
  EXPECT_EQ(ui::shown_dialog(editor_.state()), ui::Dialog::none);
}

TEST_F(EditorFiles, WhatALinkBesideASceneLeadsToIsNoneOfItsEdits) {
  const fs::path users = test_folder() / "users", own = small_wall_file();
  fs::create_directories(users);
  fs::copy_file(own, users / "scene.json");
  fs::create_directory_symlink(users, test_folder() / ".small_wall.json.edits-a1b2c3");
  editor_.enable_autosave(states());
  editor_.builder().open(own);
  wait_for_work();
  EXPECT_TRUE(editor_.state().recoverable_edits.empty());
  editor_.execute({.name = "file.discard_copy"});
  EXPECT_TRUE(fs::exists(users / "scene.json"));
}

TEST_F(EditorFiles, OpeningASceneAsksForWhatWasLeftBesideIt) {
  const fs::path own = small_wall_file();
  leave_edits(small_wall(), own);
  for (const auto& entry : fs::directory_iterator(states())) fs::remove(entry.path());
  editor_.enable_autosave(states());
  EXPECT_TRUE(editor_.state().recoverable_edits.empty());
  editor_.builder().open(own);
  wait_for_work();
  EXPECT_THAT(value("left_edits/text"), HasSubstr("small_wall.json"));
}

TEST_F(EditorFiles, OpeningASceneAsksForNoOthers) {
  leave_edits(small_wall(), "");
  editor_.enable_autosave(states());
  draw(4);
  click("left_edits/later");
  editor_.builder().open(small_wall_file());
  wait_for_work();
  EXPECT_TRUE(editor_.state().recoverable_edits.empty());
}

TEST_F(EditorFiles, ASceneOpenedInPlaceOfAnAnswerLeavesWhatACrashLeft) {
  leave_edits(small_wall(), "");
  editor_.enable_autosave(states());
  EXPECT_FALSE(editor_.state().recoverable_edits.empty());
  editor_.execute({.name = "file.open_path", .path = small_wall_file()});  // as one dropped on the window is
  wait_for_work();
  EXPECT_TRUE(editor_.state().recoverable_edits.empty());
  editor_.execute({.name = "file.recover"});
  EXPECT_EQ(editor_.run().frame().materials[0].name, small_wall().bodies[0].material.name);
  EXPECT_EQ(copies_in(states()), 1);
}

TEST_F(EditorFiles, ACopyThatFailedIsTriedAgain) {
  fs::create_directories(test_folder() / "away");
  const fs::path own = test_folder() / "away/wall.json";
  fs::copy_file(small_wall_file(), own);
  editor_.builder().open(own);
  draw(2);
  editor_.enable_autosave(states());
  fs::rename(own.parent_path(), test_folder() / "moved");
  choose_material("concrete");
  editor_.recovery().copy(1);
  EXPECT_EQ(copies_in(states()), 0);
  fs::rename(test_folder() / "moved", own.parent_path());
  editor_.recovery().copy(62);
  EXPECT_EQ(copies_in(own.parent_path()), 1);
}

}  // namespace
}  // namespace griffith::app
