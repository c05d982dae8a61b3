#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/editor/script.h"
#include "editor_fixture.h"
#include "sim/core/read_file.h"
#include "sim/scene/scene_reader.h"

namespace griffith::app {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

TEST_F(EditorTest, EveryCommandThatMakesNoSenseSaysWhyAndDoesNothing) {
  int refused = 0;
  for (const ui::CommandInfo& info : command_registry()) {
    const std::string reason(editor_.disabled_reason(info.name));
    if (reason.empty()) continue;
    const Scene scene = editor_.document().scene();
    editor_.execute({.name = info.name});
    draw(2);
    EXPECT_EQ(value("status/message"), std::string(info.label) + ": " + reason) << info.name;
    EXPECT_EQ(editor_.document().scene(), scene) << info.name;
    EXPECT_FALSE(editor_.state().save_as) << info.name;
    ++refused;
  }
  EXPECT_GT(refused, 10);
}

TEST_F(EditorTest, AShortcutThatMakesNoSenseSaysWhyUntilSomethingElseIsDone) {
  press_key('E', true);
  EXPECT_EQ(value("status/message"), "Export run…: No step has been simulated yet.");
  const std::size_t lines = editor_.state().log.size();
  press_key('E', true);
  EXPECT_EQ(editor_.state().log.size(), lines) << "once is enough";
  EXPECT_EQ(value("status/message"), "Export run…: No step has been simulated yet.");
  click("command/simulation.step");
  EXPECT_THAT(value("status/message"), ::testing::Not(HasSubstr("No step has been simulated")));
  press_key('E', true);
  EXPECT_TRUE(editor_.state().save_as) << "now there is something to export";
}

TEST_F(EditorTest, AStepOrBranchThatIsNotThereIsRefused) {
  for (int i = 0; i < 3; ++i) editor_.run().step();
  editor_.execute({.name = "time.step", .step = 9});
  ASSERT_TRUE(editor_.state().error);
  EXPECT_EQ(editor_.state().error->where, "step 9 of branch 0");
  EXPECT_EQ(editor_.state().error->remedy, "only steps 0 to 3 are recorded");
  editor_.execute({.name = "time.branch", .step = 2, .branch = 7});
  EXPECT_EQ(editor_.state().error->where, "branch 7");
  EXPECT_EQ(editor_.run().frame().step, 3);
}

TEST(RefusedCommand, ADialogGivenItsFileInAScriptIsNoDialog) {
  const auto command = [](const std::string& line) {
    return parse_script("command " + line, "a.script").front().command;
  };
  EXPECT_EQ(command("file.save_as out.json").name, "file.save");
  EXPECT_EQ(command("file.save_as out.json").path, "out.json");
  EXPECT_EQ(command("file.save_as").name, "file.save_as");
  EXPECT_EQ(command("file.export out.glb").name, "file.write_export");
  EXPECT_EQ(command("file.open out.json").name, "file.open_path");
  for (const ui::CommandInfo& info : command_registry())
    if (info.argument == ui::CommandArgument::none) {
      try {
        command(std::string(info.name) + " here.json");
        ADD_FAILURE() << info.name;
      } catch (const InputError& error) {
        EXPECT_THAT(error.what(), HasSubstr("takes no argument")) << info.name;
      }
    }
}

TEST(RefusedCommand, AScriptSavesWhereItSays) {
  const fs::path wall = small_wall_file(), copy = test_folder() / "copy.json";
  fs::remove(copy);
  const fs::path script = test_file("a.script", "command file.save_as " + copy.string() + "\n");
  const Outcome saved = run_program("script " + script.string() + " " + wall.string());
  EXPECT_EQ(saved.code, 0) << saved.output;
  EXPECT_EQ(read_scene(copy).name, "small wall");
  const Outcome again = run_program("script " + script.string() + " " + wall.string());
  EXPECT_EQ(again.code, 2) << "nobody was asked whether the file may go";
  EXPECT_THAT(again.output, HasSubstr("file.save is waiting"));
  EXPECT_THAT(again.output, HasSubstr("replace/replace"));
  const fs::path early = test_file("early.script", "command file.export " + (test_folder() / "run.glb").string());
  const Outcome exported = run_program("script " + early.string() + " " + wall.string());
  EXPECT_EQ(exported.code, 2);
  EXPECT_THAT(exported.output, HasSubstr("No step has been simulated yet"));
}

}  // namespace
}  // namespace griffith::app
