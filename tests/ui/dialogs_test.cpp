#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "ui/dialogs/dialog_window.h"
#include "ui/widgets/style.h"
#include "ui_driver.h"

namespace griffith::ui {
namespace {

TEST(Dialogs, ErrorIsShownUntilClosed) {
  UiDriver ui(two_walls());
  ui.state.error = ErrorMessage{"wall.json#/bodies/0", "has no shape", "add a box"};
  for (int i = 0; i < 3; ++i) ui.frame();
  ui.click("command/simulation.step");  // behind the dialog
  EXPECT_TRUE(ui.commands.empty());
  ui.click("error/close");
  EXPECT_FALSE(ui.state.error.has_value());
  ui.click("command/simulation.step");
  EXPECT_EQ(ui.commands.size(), 1u);
}

TEST(Dialogs, AnErrorIsRedUntilTheUserGoesOn) {
  UiDriver ui(two_walls());
  ui.state.log.push_back({LogLevel::error, "broken"});
  ui.state.error = ErrorMessage{"here", "broken", "mend it"};
  for (int i = 0; i < 3; ++i) ui.frame();
  EXPECT_EQ(find_tag(ui.tags, "status/message")->color, palette::kError);
  ui.click("error/close");
  EXPECT_EQ(find_tag(ui.tags, "status/message")->color, palette::kTextDim);
  ui.state.log.push_back({LogLevel::warning, "odd"});
  ui.frame();
  EXPECT_EQ(find_tag(ui.tags, "status/message")->color, palette::kWarning);
  ui.click("command/simulation.step");
  EXPECT_EQ(find_tag(ui.tags, "status/message")->color, palette::kTextDim);
}

TEST(Dialogs, EscapeClosesListsAndMenusAndNotTheDialogAroundThem) {
  UiDriver ui(two_walls());
  const auto escape = [&ui] {
    ui.press_key(key::kEscape);
    ui.frame();
  };
  ui.click("view/quantity");
  ASSERT_NE(find_tag(ui.tags, "view/quantity/material"), nullptr);
  escape();
  EXPECT_EQ(find_tag(ui.tags, "view/quantity/material"), nullptr);
  ui.click("menu/File");
  escape();
  EXPECT_EQ(ui.value("menu/File"), "closed");
  ui.state.show_surface = true;
  for (int i = 0; i < 3; ++i) ui.frame();
  ui.click("surface/method");
  escape();
  EXPECT_EQ(find_tag(ui.tags, "surface/method/TetGen"), nullptr);
  EXPECT_TRUE(ui.state.show_surface);
  ui.click("surface/scale", 1);
  ui.frame();
  ui.press_key(key::kEscape);
  EXPECT_TRUE(ui.state.show_surface) << "the key was meant for the number";
  ui.press_key(key::kEscape);
  EXPECT_FALSE(ui.state.show_surface);
}

TEST(Dialogs, EscapeInAnUntouchedFieldLeavesTheDialog) {
  UiDriver ui(two_walls());
  ui.state.save_as = save_target("a.json");
  for (int i = 0; i < 3; ++i) ui.frame();
  ASSERT_TRUE(ImGui::GetIO().WantTextInput);
  ui.press_key(key::kEscape);
  EXPECT_FALSE(ui.state.save_as);
}

TEST(Dialogs, OpenDialogTakesATypedPath) {
  UiDriver ui(two_walls());
  ui.state.show_open = true;
  for (int i = 0; i < 3; ++i) ui.frame();
  ui.click("open/path");
  ui.type("a/b.json");
  ASSERT_THAT(ui.issued(), ::testing::ElementsAre("file.open_path"));
  EXPECT_EQ(ui.commands[0].path, "a/b.json");
  EXPECT_FALSE(ui.state.show_open);
}

TEST(Dialogs, ScenesOfTheSameNameAreDistinguishedByTheirFolder) {
  UiDriver ui(two_walls());
  const std::vector<std::filesystem::path> files = {"a/table.json", "a/wall.json", "b/wall.json"};
  ui.input.scene_files = files;
  ui.state.show_open = true;
  for (int i = 0; i < 3; ++i) ui.frame();
  EXPECT_EQ(ui.value("open/table"), "table");
  ui.click("open/wall (b)");
  ASSERT_THAT(ui.issued(), ::testing::ElementsAre("file.open_path"));
  EXPECT_EQ(ui.commands[0].path, "b/wall.json");
}

TEST(Dialogs, SaveDialogTakesATypedName) {
  UiDriver ui(two_walls());
  ui.state.save_as = save_target("/somewhere/walls.json");
  for (int i = 0; i < 3; ++i) ui.frame();
  EXPECT_EQ(ui.value("save/path"), "/somewhere/walls.json");
  ui.type("../else/table");  // it has the focus, and what was there is replaced
  ASSERT_THAT(ui.issued(), ::testing::ElementsAre("file.save"));
  EXPECT_EQ(ui.commands[0].path, "/else/table.json");
  EXPECT_FALSE(ui.state.save_as);
}

}  // namespace
}  // namespace griffith::ui
