#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <random>
#include <string>
#include <vector>

#include "app/editor/editor_commands.h"
#include "editor_fixture.h"
#include "sim/scene/scene_difference.h"
#include "sim/scene/scene_reader.h"
#include "sim/scene/scene_writer.h"

namespace griffith::app {
namespace {

/// Returns a number from the environment: more commands, or others, than the test usually tries.
int number_or(const char* variable, int otherwise) {
  const char* text = std::getenv(variable);
  return text ? std::atoi(text) : otherwise;
}

/// Commands and clicks as of a user who tries everything.
class RandomCommands : public EditorTest {
 protected:
  RandomCommands() : EditorTest(small_wall(), 900) {
    std::filesystem::current_path(test_folder());  // clicks may save
    editor_.state().view.quality = PictureQuality::draft;
  }
  ~RandomCommands() override { std::filesystem::current_path(before_); }

  double real(double from, double to) { return std::uniform_real_distribution(from, to)(random_); }
  std::size_t below(std::size_t count) { return std::uniform_int_distribution<std::size_t>(0, count - 1)(random_); }

  /// Returns some command that reads and writes no files, with an argument in its range.
  ui::Command any_command() {
    const ui::CommandInfo* info = nullptr;
    while (!info || !info->for_pictures) info = &command_registry()[below(command_registry().size())];
    ui::Command command{.name = info->name};
    command.cursor = Vec2(real(0, 1), real(0, 1));
    command.offset = Vec3(real(-2, 2), real(0, 2), real(-2, 2));
    command.step = static_cast<std::int64_t>(below(info->argument == ui::CommandArgument::step ? 12 : 3));
    command.branch = static_cast<int>(below(3));
    command.discard_edits = true;
    return command;
  }

  /// Changes something by a command, a click at any place of the window, or a key.
  void do_something() {
    const double what = real(0, 1);
    last_ = "click";
    if (what < 0.8) {
      const ui::Command command = any_command();
      last_ = std::string(command.name);
      editor_.execute(command);
      return draw();
    }
    if (what < 0.9) {
      ui::click(queue_, {static_cast<float>(real(0, 900)), static_cast<float>(real(30, 1060))}, 0);
      play();
    }
    last_ = "Escape";
    press_key(ui::key::kEscape);
  }

  /// Answers dialogs, waits for what is being built, and starts a new scene before the scene is slow.
  void settle() {
    for (int i = 0; i < 40 && ui::is_busy(editor_.state()); ++i) {
      editor_.run().advance(0.01);
      draw();
    }
    editor_.state().steps_left = 0;
    press_key(ui::key::kEscape);  // cancels the work, or a question
    editor_.state().error.reset();
    if (editor_.document().scene().bodies.size() > 6 || editor_.run().frame().elements.tets.size() > 4000)
      editor_.execute({.name = "file.new", .discard_edits = true});
    draw();
  }

  /// Expects what holds in every state of the editor.
  void check() {
    const Frame frame = editor_.run().frame();
    for (const Vec3& position : frame.nodes.positions) ASSERT_TRUE(position.allFinite());
    const ui::Selection& selection = editor_.state().selection;
    ASSERT_TRUE(!selection.valid() || selection.node.index() < std::ssize(frame.nodes.positions));
    const Scene& scene = editor_.document().scene();
    const Scene read = scene_from_json(scene_to_json(scene), "scene.json", scene.folder);
    for (const FieldChange& change : field_changes(full_scene_text(scene), full_scene_text(read)))
      if (!change.pointer.starts_with("/materials/"))  // a list of what bodies may be made of
        ADD_FAILURE() << change.pointer << " " << change.before.value_or("-") << " is read as "
                      << change.after.value_or("-");
  }

  std::filesystem::path before_ = std::filesystem::current_path();
  std::mt19937 random_{static_cast<unsigned>(number_or("GRIFFITH_RANDOM_SEED", 1))};
  std::string last_;
};

TEST_F(RandomCommands, LeaveAWholeEditor) {
  const int count = number_or("GRIFFITH_RANDOM_COMMANDS", 150);
  for (int i = 0; i < count; ++i) {
    do_something();
    SCOPED_TRACE("after " + std::to_string(i) + ", " + last_);
    settle();
    check();
    if (HasFailure()) return;
    if (count > 1000 && i % 500 == 0) std::printf("%d commands\n", i);
  }
}

TEST_F(RandomCommands, AreUndoneAndDoneAgain) {
  const int count = number_or("GRIFFITH_RANDOM_COMMANDS", 150) / 3;
  for (int i = 0; i < count; ++i) do_something(), settle();
  ui::EditHistory& history = editor_.document().history();
  history.finish();
  while (history.can_redo()) history.redo();
  std::vector<Scene> scenes = {history.scene()};
  for (; history.can_undo(); scenes.push_back(history.scene())) history.undo();
  for (auto scene = scenes.rbegin() + 1; scene != scenes.rend(); ++scene) {
    ASSERT_TRUE(history.can_redo());
    history.redo();
    EXPECT_TRUE(history.scene() == *scene);
  }
  EXPECT_FALSE(history.can_redo());
}

}  // namespace
}  // namespace griffith::app
