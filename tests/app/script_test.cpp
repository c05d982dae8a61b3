#include "app/editor/script.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <random>

#include "app/editor/script_player.h"
#include "editor_fixture.h"
#include "sim/core/read_file.h"
#include "sim/scene/scene_reader.h"
#include "sim/scene/scene_writer.h"
#include "tests/input_error_of.h"

namespace griffith::app {
namespace {

using ::testing::HasSubstr;

std::string problem_of(const std::string& text) {
  return input_error_of([&] { parse_script(text, "a.script"); });
}

TEST(Script, ReadsEveryVerb) {
  const Script script = parse_script(
      "# a comment\n\n"
      "command simulation.step\ncommand file.open_path \"my wall.json\"\n"
      "click menu/File\nclick viewport right  # fires\ndrag viewport 20 -4.5\nscroll body/name -3\n"
      "type material/density \"2 t \\\"x\\\"\"\nkey Ctrl+Z\nstep 10\nwait\n"
      "expect toolbar/step \"step 10\"\nexpect viewport\nsay viewport \"Look\"\nsay Hello\nscreenshot out.png\n",
      "a.script");
  ASSERT_EQ(script.size(), 15u);
  EXPECT_EQ(script[0].place, "a.script:3");
  EXPECT_EQ(script[0].command.name, "simulation.step");
  EXPECT_EQ(script[1].command.path, "my wall.json");
  EXPECT_EQ(script[3].button, 1);
  EXPECT_EQ(script[4].down, -4.5f);
  EXPECT_EQ(script[5].tag, "body/name");
  EXPECT_EQ(script[5].down, -3);
  EXPECT_EQ(script[6].text, "2 t \"x\"");
  EXPECT_EQ(script[7].key, (ui::Shortcut{'Z', true, false}));
  EXPECT_EQ(script[8].count, 10);
  EXPECT_EQ(script[9].count, 1);
  EXPECT_FALSE(script[10].any_value);
  EXPECT_TRUE(script[11].any_value);
  EXPECT_EQ(script[12].tag, "viewport");
  EXPECT_EQ(script[13].text, "Hello");
  EXPECT_EQ(script[14].verb, Verb::screenshot);
}

TEST(Script, MistakesNameTheirLineAndTheRemedy) {
  EXPECT_THAT(problem_of("wait\njump 3"), HasSubstr("a.script:2: begins with \"jump\""));
  EXPECT_THAT(problem_of("jump"), HasSubstr("click, drag"));
  EXPECT_THAT(problem_of("command no.such"), HasSubstr("names no command"));
  EXPECT_THAT(problem_of("command time.step"), HasSubstr("lacks the step"));
  EXPECT_THAT(problem_of("command time.step -1"), HasSubstr("from 0 to"));
  EXPECT_THAT(problem_of("command simulation.fire 0.5 nan"), HasSubstr("from 0 to 1"));
  EXPECT_THAT(problem_of("click"), HasSubstr("lacks the tag"));
  EXPECT_THAT(problem_of("click viewport twice"), HasSubstr("left, right or middle"));
  EXPECT_THAT(problem_of("step 0"), HasSubstr("from 1 to"));
  EXPECT_THAT(problem_of("step 99999999999999999999"), HasSubstr("from 1 to"));
  EXPECT_THAT(problem_of("key Ctrl+Qq"), HasSubstr("is not a key"));
  EXPECT_THAT(problem_of("say \"without end"), HasSubstr("unterminated quote"));
  EXPECT_THAT(problem_of("expect a b c"), HasSubstr("\"c\" at its end"));
  EXPECT_THAT(problem_of("screenshot out.jpg"), HasSubstr(".png"));
}

TEST(Script, CommandsAreReadBackAsTheyWereWritten) {
  for (const ui::CommandInfo& info : command_registry()) {
    ui::Command command{.name = info.name, .path = "my \"wall\".json", .step = 12, .branch = 1, .cursor = {0.25, 0.5}};
    const Script script = parse_script(script_line(command), "a.script");
    ASSERT_EQ(script.size(), 1u);
    EXPECT_EQ(script[0].command.name, info.name);
    EXPECT_EQ(script_line(script[0].command), script_line(command));
  }
}

TEST(Script, TheTourIsOne) { EXPECT_GT(tour().size(), 10u); }

TEST(Script, ThatOfTheTutorialDrawsItsPictures) {
  const std::filesystem::path docs = std::filesystem::path(GRIFFITH_SOURCE_DIR) / "docs";
  std::size_t pictures = 0;
  for (const ScriptLine& line : read_script(docs / "tutorial.script")) {
    if (line.verb != Verb::screenshot) continue;
    EXPECT_TRUE(std::filesystem::exists(docs.parent_path() / line.text)) << line.text;
    ++pictures;
  }
  EXPECT_EQ(pictures, 4u);
}

class ScriptPlayerTest : public EditorTest {
 protected:
  void play_script(const std::string& text) {
    ScriptPlayer player(parse_script(text, "a.script"), false);
    while (!player.done() || !queue_.empty() || !editor_.state().work.empty()) {
      player.advance(editor_, queue_);
      queue_.play(ImGui::GetIO());
      editor_.run().advance(1.0 / 60);
      draw_while_working();
    }
  }

  std::string failure_of(const std::string& text) {
    return input_error_of([&] { play_script(text); });
  }
};

TEST_F(ScriptPlayerTest, DoesWhatHandsDo) {
  play_script(
      "step 3\nexpect toolbar/step \"step 3\"\n"
      "click command/simulation.reset\nexpect toolbar/step \"step 0\"\n"
      "type material/young_modulus \"20 GPa\"\nkey N\nexpect toolbar/step \"step 1\"\n"
      "click menu/Edit\nclick menu/edit.undo\n");
  EXPECT_EQ(editor_.run().frame().step, 1);
  EXPECT_NE(editor_.run().frame().materials[0].young_modulus, 20e9) << "undone by the menu";
  play_script("key Ctrl+Shift+Z\n");
  EXPECT_EQ(editor_.run().frame().materials[0].young_modulus, 20e9);
}

TEST_F(ScriptPlayerTest, AGlassTableIsBuiltByHandBrokenAndExplained) {
  std::string script = read_file(std::filesystem::path(GRIFFITH_SOURCE_DIR) / "docs/glass_table.script");
  const std::string new_scene = "command file.new\n";
  script.insert(script.find(new_scene) + new_scene.size(), "set view/quality draft\n");
  play_script(script);
  const Scene& scene = editor_.document().scene();
  ASSERT_EQ(scene.bodies.size(), 6u);
  EXPECT_EQ(scene.bodies[4].position, Vec3(0.35, 0.3, 0.35));
  EXPECT_EQ(scene.bodies[5].material, *find_material_preset("brick"));
  EXPECT_LE(editor_.run().frame().energy.stored(), 1.01 * editor_.run().frame().energy.put_in());
  EXPECT_GT(editor_.run().frame().fragments, 0);
  EXPECT_FALSE(editor_.state().error.has_value());
}

TEST_F(ScriptPlayerTest, OpensAndWaitsForTheWorld) {
  play_script("command file.open_path " + small_wall_file().string() + "\nexpect status/file small_wall.json\n");
}

TEST_F(ScriptPlayerTest, WhatIsNotAsExpectedNamesItsLine) {
  EXPECT_THAT(failure_of("wait\nexpect toolbar/step \"step 7\""),
              HasSubstr("a.script:2: toolbar/step shows \"step 0\" instead of \"step 7\""));
  EXPECT_THAT(failure_of("command edit.redo"),
              HasSubstr("a.script:1: edit.redo is disabled (There is no edit to redo.)"));
  EXPECT_THAT(failure_of("command file.fill_surface"), HasSubstr("No surface file"));
  EXPECT_THAT(failure_of("click no/such"), HasSubstr("a.script:1: there is no widget \"no/such\""));
}

TEST_F(ScriptPlayerTest, ADragTurnsTheCameraAndAPictureIsAskedForOnce) {
  editor_.state().running = false;
  ScriptPlayer player(parse_script("screenshot a.png", "a.script"), false);
  player.advance(editor_, queue_);
  EXPECT_EQ(player.take_picture_request(), "a.png");
  EXPECT_FALSE(player.take_picture_request());
}

TEST_F(ScriptPlayerTest, TheTourGoesOnByNextAndEndsBySkip) {
  ScriptPlayer player(tour(), true);
  const auto frames = [&](int count) {
    for (int i = 0; i < count; ++i) {
      player.advance(editor_, queue_);
      draw();
    }
  };
  frames(20);
  const std::string first = value("caption/text");
  EXPECT_NE(first, "no widget caption/text");
  click("caption/next");
  frames(30);
  EXPECT_NE(value("caption/text"), first);
  EXPECT_FALSE(player.done());
  click("caption/skip");
  frames(2);
  EXPECT_TRUE(player.done());
  draw(2);
  EXPECT_EQ(value("caption/text"), "no widget caption/text");
}

TEST_F(ScriptPlayerTest, TheWholeTourPlaysAndAllThatItPointsAtIsThere) {
  ScriptPlayer player(tour(), true);
  int said = 0;
  for (int i = 0; i < 20000 && !player.done(); ++i) {
    player.advance(editor_, queue_);
    draw_while_working();
    std::optional<ui::Caption>& caption = editor_.state().caption;
    if (!caption) continue;
    EXPECT_TRUE(caption->tag.empty() || ui::find_tag(editor_.tags(), caption->tag)) << caption->tag;
    caption->answer = ui::Caption::Answer::next;
    ++said;
  }
  EXPECT_TRUE(player.done());
  EXPECT_GE(said, 7) << "five steps between a beginning and an end";
  EXPECT_FALSE(editor_.state().error);
}

/// Does what nobody would do, in an order that nobody thought of. GRIFFITH_RANDOM_ACTIONS and GRIFFITH_RANDOM_SEED make
/// it longer and another.
class RandomActions : public EditorTest {
 protected:
  RandomActions() : random_(static_cast<unsigned>(number_from("GRIFFITH_RANDOM_SEED", 1))) {
    const std::filesystem::path folder = test_folder() / "random";
    std::filesystem::create_directories(folder);
    std::filesystem::current_path(folder);  // dialogs write to it
  }

  static int number_from(const char* variable, int otherwise) {
    const char* text = std::getenv(variable);
    return text ? std::atoi(text) : otherwise;
  }

  int below(std::size_t count) { return static_cast<int>(random_() % count); }

  /// Scenes of the lists are passed by: the largest takes a minute to build.
  static bool is_scene(const std::string& tag) {
    return tag.starts_with("open/") || tag.starts_with("scenes/") || tag.starts_with("menu/recent/");
  }

  void click_anywhere() {
    const ui::WidgetTags& tags = editor_.tags();
    const ui::WidgetTag& tag = tags[static_cast<std::size_t>(below(tags.size()))];
    if (is_scene(tag.name)) return;
    if (below(4) == 0) {
      ui::drag(queue_, tag.center(), {static_cast<float>(below(200)) - 100, static_cast<float>(below(60)) - 30});
    } else {
      ui::click(queue_, tag.center(), below(3));
    }
    play();
  }

  void issue_any_command() {
    const std::span<const ui::CommandInfo> registry = command_registry();
    const ui::CommandInfo& info = registry[static_cast<std::size_t>(below(registry.size()))];
    editor_.execute({.name = info.name,
                     .path = any_path(),
                     .step = below(20),
                     .cursor = {below(100) / 100.0, below(100) / 100.0},
                     .discard_edits = below(2) == 0,
                     .replace = below(2) == 0});
    draw();
  }

  /// Returns a path to open, save, record or export: some exist, some are damaged, some are impossible.
  std::filesystem::path any_path() {
    const std::filesystem::path paths[] = {
        "any.json",
        "any.tar.zst",
        "any.glb",
        "any.usda",
        "any.html",
        "any.csv",
        "any.png",
        "any.script",
        "",
        ".",
        "no/such/any.json",
        small_wall_file(),
        test_file("cut.json", R"({"version": 1, "bodies": [{)"),
        test_file("odd.json", R"({"version": 1, "bodies": [{"shape": {"mesh": {"path": "cut.json"}}}]})"),
        test_file("box.off", "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n")};
    return paths[below(std::size(paths))];
  }

  /// Checks that no temporary file is left, and no file is truncated.
  static void check_files() {
    for (const auto& entry : std::filesystem::directory_iterator(".")) {
      EXPECT_FALSE(entry.path().filename().string().starts_with(".griffith_")) << entry.path();
      EXPECT_FALSE(entry.is_regular_file() && entry.file_size() == 0) << entry.path();
    }
  }

  void press_any_key() {
    constexpr int kKeys[] = {'N',
                             'R',
                             'F',
                             'E',
                             'L',
                             'X',
                             'M',
                             'Z',
                             'D',
                             'P',
                             'S',
                             'G',
                             'H',
                             ui::key::kSpace,
                             ui::key::kEscape,
                             ui::key::kEnter,
                             ui::key::kDelete,
                             ui::key::kHome,
                             ui::key::kLeft,
                             ui::key::kF1,
                             ui::key::kF1 + 1,
                             ui::key::kTab,
                             ui::key::kUp,
                             ui::key::kDown};
    ui::press(queue_, {kKeys[below(std::size(kKeys))], below(3) == 0, below(5) == 0});
    play();
  }

  void type_anything() {
    constexpr const char* kTexts[] = {"20 GPa", "-1", "1e999", "nan", "", "glass", "0", "ä€", "%s%n", "99999999999"};
    ui::type(queue_, kTexts[below(std::size(kTexts))]);
    ui::press(queue_, {ui::key::kEnter});
    play();
  }

  void act() {
    switch (below(8)) {
      case 0:
      case 1:
        return issue_any_command();
      case 2:
        return press_any_key();
      case 3:
        return type_anything();
      case 4:
        editor_.run().advance(1.0 / 60);
        return draw();
      default:
        return click_anywhere();
    }
  }

  /// Keeps the work of a step small.
  void tidy_up() {
    editor_.state().work.empty() ? void() : wait_for_work();
    if (editor_.run().frame().elements.tets.size() > 4000) editor_.builder().open(small_wall_file());
  }

  /// Undoes all edits and makes them again: each scene returns.
  void check_history() {
    ui::EditHistory& history = editor_.document().history();
    history.finish();
    std::vector<Scene> scenes = {history.scene()};
    for (; history.can_undo(); scenes.push_back(history.scene())) history.undo();
    for (auto scene = scenes.rbegin() + 1; scene != scenes.rend(); ++scene) {
      history.redo();
      ASSERT_TRUE(history.scene() == *scene);
    }
  }

  std::mt19937 random_;
};

TEST_F(RandomActions, LeaveAnEditorThatWorks) {
  const int actions = number_from("GRIFFITH_RANDOM_ACTIONS", 40);
  for (int i = 0; i < actions; ++i) {
    act();
    tidy_up();
    ASSERT_FALSE(editor_.tags().empty());
    for (const Vec3& position : editor_.run().frame().nodes.positions)
      ASSERT_TRUE(position.allFinite()) << "action " << i;
    ASSERT_TRUE(check_scene_text(scene_to_json(editor_.document().scene()), "scene").empty()) << "action " << i;
    check_files();
  }
  check_history();
  editor_.execute({.name = "file.new", .discard_edits = true});
  draw(2);
  EXPECT_EQ(editor_.run().frame().step, 0);
}

}  // namespace
}  // namespace griffith::app
