// What is done by hand, recorded as a script, played again.

#include <gmock/gmock.h>

#include <fstream>

#include "app/editor/script_player.h"
#include "editor_fixture.h"
#include "sim/core/error.h"
#include "sim/scene/scene_writer.h"
#include "tests/input_error_of.h"

namespace griffith::app {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

std::string macro_text(const fs::path& file) {
  std::ifstream stream(file);
  return {std::istreambuf_iterator<char>(stream), {}};
}

class MacroTest : public EditorTest {
 protected:
  MacroTest() {
    fs::remove_all(test_folder());
    editor_.scripting().use_macros(macros());
  }

  static fs::path macros() { return test_folder() / "macros"; }

  void toggle_recording() {
    click("menu/Edit");
    click("menu/edit.record_macro");
    draw(3);
  }

  /// Stops the recording and saves it by that name. Returns its text.
  std::string save_recorded(const std::string& name) {
    toggle_recording();
    draw(4);  // the dialog takes the focus
    type(name);
    EXPECT_EQ(value("save/name"), name);
    click("save/save");
    draw(3);
    return macro_text(macros() / (name + ".script"));
  }

  void drag(const std::string& tag, float right, float down) {
    const ui::WidgetTag* widget = ui::find_tag(editor_.tags(), tag);
    ASSERT_NE(widget, nullptr) << tag;
    ui::drag(queue_, widget->center(), {right, down});
    play();
    draw(2);
    wait_for_work();
  }

  void play_script(const Script& script) {
    ScriptPlayer player(script, false);
    while (!player.done() || !queue_.empty() || !editor_.state().work.empty()) {
      player.advance(editor_, queue_);
      queue_.play(ImGui::GetIO());
      draw_while_working();
    }
  }

  /// Plays what was recorded in another editor of the same scene, from its start.
  void start_anew() {
    write_scene(small_wall(), test_folder() / "wall.json");
    editor_.execute({.name = "file.open_path", .path = test_folder() / "wall.json", .discard_edits = true});
    wait_for_work();
  }

  std::string scene_text() const {
    Scene scene = editor_.document().scene();
    scene.view = const_cast<Editor&>(editor_).state().view;
    scene.schema.clear();
    return scene_to_json(scene);
  }
};

TEST_F(MacroTest, WhatIsRecordedDoesTheSameAgain) {
  start_anew();
  toggle_recording();
  EXPECT_EQ(value("status/recording"), "recording a macro");
  choose_material("concrete");
  editor_.execute({.name = "add.support"});
  draw(3);
  wait_for_work();
  drag("region/3", 4, -40);
  press_key('E');  // edges
  editor_.state().shot.speed = 17;
  draw();
  drag("viewport", 60, 20);
  editor_.execute({.name = "simulation.fire", .cursor = {0.5, 0.45}});
  draw();
  for (int i = 0; i < 5; ++i) editor_.run().step(), draw();
  const std::string made = scene_text();
  const std::uint64_t hash = editor_.run().timeline().world().state_hash();
  const std::string recorded = save_recorded("all of it");
  EXPECT_THAT(recorded, HasSubstr("command add.support"));
  EXPECT_THAT(recorded, HasSubstr("command simulation.fire 0.5 0.45"));
  EXPECT_THAT(recorded, HasSubstr("step 5"));
  EXPECT_THAT(recorded, HasSubstr("projectile speed 17"));
  start_anew();
  EXPECT_NE(scene_text(), made);
  play_script(read_script(macros() / "all of it.script"));
  EXPECT_EQ(scene_text(), made);
  EXPECT_EQ(editor_.run().timeline().world().state_hash(), hash) << recorded;
}

TEST_F(MacroTest, UndoTakesBackOneRecordedEdit) {
  toggle_recording();
  choose_material("concrete");
  choose_material("ice");
  press_key('Z', true);
  const std::string recorded = save_recorded("undo");
  editor_.execute({.name = "edit.undo"});
  draw();
  EXPECT_NE(editor_.document().scene().bodies[0].material.name, "concrete");
  play_script(parse_script(recorded, "undo"));
  EXPECT_EQ(editor_.document().scene().bodies[0].material.name, "concrete") << recorded;
}

TEST_F(MacroTest, QuestionsAndTimeItselfAreNotRecorded) {
  toggle_recording();
  press_key('O', true);
  draw(3);
  press_key(ui::key::kEscape);
  press_key(ui::key::kSpace);
  press_key(ui::key::kSpace);
  const std::string recorded = save_recorded("nothing");
  EXPECT_THAT(recorded, HasSubstr("# Recorded"));
  EXPECT_THAT(recorded, ::testing::Not(HasSubstr("command")));
}

TEST_F(MacroTest, TheStatusBarStopsTheRecording) {
  toggle_recording();
  click("status/recording");
  draw(3);
  EXPECT_EQ(value("save/name"), "macro 1.script");
  EXPECT_EQ(value("status/recording"), "no widget status/recording");
}

TEST_F(MacroTest, ThePaletteAndTheMenuPlayMacrosByName) {
  fs::create_directories(macros());
  std::ofstream(macros() / "make glass.script") << "set bodies/0/material ice\n";
  editor_.scripting().use_macros(macros());
  draw(2);
  press_key('P', true);
  draw(3);
  type("make glass");
  EXPECT_EQ(value("palette/macro/make glass"), "make glass");
  press_key(ui::key::kEnter);
  draw(2);
  const std::optional<Script> wanted = editor_.scripting().take_request();
  ASSERT_TRUE(wanted);
  play_script(*wanted);
  EXPECT_EQ(editor_.document().scene().bodies[0].material.name, "ice");
}

TEST_F(MacroTest, AScriptPlaysMacrosButNoneThatPlaysItself) {
  fs::create_directories(macros());
  const fs::path inner = macros() / "inner.script", loop = macros() / "loop.script";
  std::ofstream(inner) << "step 2\n";
  play_script(parse_script("command edit.play_macro \"" + inner.string() + "\"\nstep\n", "outer"));
  EXPECT_EQ(editor_.run().frame().step, 3);
  const std::string plays_itself = "command edit.play_macro \"" + loop.string() + "\"\n";
  std::ofstream many(loop);
  many << plays_itself;
  for (int i = 0; i < 1000; ++i) many << "wait\n";
  many.close();
  EXPECT_THROW(play_script(parse_script(plays_itself, "outer")), InputError);
}

TEST_F(MacroTest, LinesThatDoNotFitTheSceneAreNamed) {
  const auto failure = [&](const std::string& line) -> std::string {
    return input_error_of([&] { play_script(parse_script(line, "a.script")); });
  };
  const std::string before = scene_text();
  EXPECT_THAT(failure("set bodies/7/name x"), HasSubstr("a.script:1"));
  EXPECT_THAT(failure("set gravity down"), HasSubstr("a.script:1"));
  EXPECT_THAT(failure("set gravity"), HasSubstr("lacks a value"));
  EXPECT_THAT(failure("projectile speed fast"), HasSubstr("a.script:1"));
  EXPECT_THAT(failure("choose nobody"), HasSubstr("the scene has no \"nobody\""));
  EXPECT_THAT(failure("look 1 2 3 1 2 3"), HasSubstr("has the eye at the target"));
  EXPECT_EQ(scene_text(), before);
}

}  // namespace
}  // namespace griffith::app
