#include "ui/model/command_search.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "ui_driver.h"

namespace griffith::ui {
namespace {

std::string_view best(std::string_view wanted) {
  const std::vector<const CommandInfo*> found = matching_commands(app::command_registry(), wanted);
  return found.empty() ? "nothing" : found.front()->name;
}

TEST(CommandSearch, LettersAreFoundInTheirOrderWhateverTheirCase) {
  EXPECT_TRUE(match_score("Save as…", "sa"));
  EXPECT_TRUE(match_score("Save as…", "SVS"));
  EXPECT_FALSE(match_score("Save as…", "sx"));
  EXPECT_FALSE(match_score("Step", "pets"));
  EXPECT_GT(*match_score("Go to start", "gts"), *match_score("Element edges", "ets")) << "beginnings of words count";
}

TEST(CommandSearch, EveryCommandOfAMenuIsFoundFirstByItsTitle) {
  for (const CommandInfo& info : app::command_registry()) {
    const std::vector<const CommandInfo*> found = matching_commands(app::command_registry(), info.label);
    EXPECT_EQ(std::ranges::count(found, &info), info.menu == Menu::none ? 0 : 1) << info.name;
    EXPECT_TRUE(info.menu == Menu::none || found.front()->label == info.label) << info.name;
  }
}

TEST(CommandSearch, NumbersAfterTheLettersAreTheArgument) {
  EXPECT_EQ(best("go step 12"), "time.step");
  EXPECT_EQ(best("array 4 0.5 0 -1"), "edit.array");
  EXPECT_EQ(best("fire 0.2 0.7"), "simulation.fire");
  EXPECT_EQ(best("fire 2 7"), "nothing") << "outside the view";
  EXPECT_EQ(best("undo 3"), "nothing") << "takes no number";
  const CommandQuery query = parse_command_query("array 4 0.5 0 -1 ");
  EXPECT_EQ(query.letters, "array");
  const std::optional<Command> command =
      with_numbers(*find_command(app::command_registry(), "edit.array"), query.numbers);
  ASSERT_TRUE(command);
  EXPECT_EQ(command->name, "edit.make_array");
  EXPECT_EQ(command->step, 4);
  EXPECT_EQ(command->offset, Vec3(0.5, 0, -1));
  EXPECT_EQ(parse_command_query("12").letters, "12") << "numbers alone are no argument";
}

TEST(CommandSearch, ABeginningOrAMenuOrAWordOfTheHelpSuffices) {
  EXPECT_EQ(best("und"), "edit.undo");
  EXPECT_EQ(best("add sph"), "add.sphere");
  EXPECT_EQ(best("projectile"), "add.projectile");
  EXPECT_EQ(best("at the cursor"), "simulation.fire");
  EXPECT_EQ(best("batch"), "file.render");
  EXPECT_EQ(best("qqq"), "nothing");
}

class PaletteTest : public ::testing::Test {
 protected:
  PaletteTest() {
    ui_.state.palette.shown = true;
    for (int i = 0; i < 4; ++i) ui_.frame();
  }
  /// Types without Enter.
  void write(const std::string& text) {
    type(ui_.queue, text);
    while (!ui_.queue.empty()) {
      ui_.queue.play(ImGui::GetIO());
      ui_.frame();
    }
    ui_.frame();
  }

  UiDriver ui_{two_walls()};
};

TEST_F(PaletteTest, EnterIssuesTheBestAndCloses) {
  write("step");
  ui_.press_key(key::kEnter);
  EXPECT_THAT(ui_.issued(), ::testing::ElementsAre("simulation.step"));
  EXPECT_FALSE(ui_.state.palette.shown);
}

TEST_F(PaletteTest, ArrowsChooseAndStopAtTheEnds) {
  const std::vector<const CommandInfo*> all = matching_commands(app::command_registry(), "");
  ui_.press_key(key::kUp);
  EXPECT_EQ(ui_.state.palette.chosen, 0);
  ui_.press_key(key::kDown);
  ui_.press_key(key::kDown);
  EXPECT_EQ(ui_.value("palette/help"), all[2]->hint);
  for (std::size_t i = 0; i < all.size() + 3; ++i) ui_.press_key(key::kDown);
  EXPECT_EQ(ui_.state.palette.chosen, static_cast<int>(all.size()) - 1);
  write("open");
  EXPECT_EQ(ui_.state.palette.chosen, 0) << "another list begins at its top";
}

TEST_F(PaletteTest, WhatMakesNoSenseSaysWhyAndStays) {
  write("redo");
  EXPECT_EQ(ui_.value("palette/help"), "There is no edit to redo.");
  ui_.press_key(key::kEnter);
  EXPECT_TRUE(ui_.commands.empty());
  EXPECT_TRUE(ui_.state.palette.shown);
}

TEST_F(PaletteTest, AClickIssuesAndEscapeCloses) {
  ui_.click("palette/file.open");
  EXPECT_THAT(ui_.issued(), ::testing::ElementsAre("file.open"));
  ui_.state.palette.shown = true;
  for (int i = 0; i < 4; ++i) ui_.frame();
  write("st");
  ui_.press_key(key::kEscape);
  EXPECT_FALSE(ui_.state.palette.shown);
  EXPECT_EQ(ui_.state.palette.text[0], '\0');
}

TEST(CommandSearch, NumbersThatACommandDoesNotTakeAreExplained) {
  const auto problem = [](std::string_view text) { return problem_of_query(app::command_registry(), text); };
  EXPECT_EQ(problem("array 4"), "Array… takes four numbers: how many, from 2 to 1000, and the offset x y z in meters.");
  EXPECT_EQ(problem("qqq"), "No command matches.");
  EXPECT_EQ(problem("save 3"), "Save takes no numbers.");
}

}  // namespace
}  // namespace griffith::ui
