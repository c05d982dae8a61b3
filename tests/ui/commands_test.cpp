#include "ui/model/commands.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <functional>
#include <regex>
#include <set>

#include "sim/core/read_file.h"
#include "ui_driver.h"

namespace griffith::ui {
namespace {

TEST(Commands, ButtonsIssueTheirCommands) {
  UiDriver ui(two_walls());
  ui.click("command/simulation.step");
  ui.click("command/simulation.run");
  ui.click("command/simulation.reset");
  EXPECT_THAT(ui.issued(), ::testing::ElementsAre("simulation.step", "simulation.run", "simulation.reset"));
}

TEST(Commands, MenusIssueTheirCommands) {
  UiDriver ui(two_walls());
  ui.click("menu/Simulation");
  ui.click("menu/simulation.step");
  EXPECT_THAT(ui.issued(), ::testing::ElementsAre("simulation.step"));
}

TEST(Commands, EveryShortcutIssuesItsCommandOnce) {
  for (const CommandInfo& info : app::command_registry()) {
    if (info.shortcut.key == key::kNone) continue;
    UiDriver ui(two_walls());
    ui.history.change("a", [](Scene& scene) { scene.name = "a"; });
    ui.history.finish();
    ui.history.change("b", [](Scene& scene) { scene.name = "b"; });
    ui.history.undo();        // now there is something to undo and to redo
    ui.input.frame.step = 3;  // and to go back to
    ui.input.time.last_step = 3;
    ui.input.time.branches = {{-1, 0, 3}, {0, 1, 3}};
    ui.state.view.range = Vec2(0, 1);
    ui.state.paint_regions = true;
    ui.state.entries = {{EntryKind::body, info.name == "edit.move_up" ? 1 : 0}};
    ui.press_key(info.shortcut.key, info.shortcut.ctrl, info.shortcut.shift, info.shortcut.alt);
    EXPECT_THAT(ui.issued(), ::testing::ElementsAre(info.name)) << info.name;
  }
}

TEST(Commands, CommandsHaveDifferentNamesAndShortcuts) {
  std::set<std::string_view> names;
  std::set<std::string> shortcuts;
  for (const CommandInfo& info : app::command_registry()) {
    EXPECT_TRUE(names.insert(info.name).second) << info.name;
    const std::string shortcut = shortcut_text(info.shortcut);
    EXPECT_TRUE(shortcut.empty() || shortcuts.insert(shortcut).second) << shortcut;
    EXPECT_TRUE(shortcut.empty() || shortcut_from_text(shortcut) == info.shortcut) << shortcut;
    EXPECT_EQ(shortcut.empty(), info.shortcut.key == key::kNone) << info.name;
    EXPECT_FALSE(info.hint.empty()) << info.name;
  }
}

/// Returns the text of all sources of a folder.
std::string sources_of(const std::filesystem::path& folder) {
  std::string text;
  for (const auto& entry :
       std::filesystem::recursive_directory_iterator(std::filesystem::path(GRIFFITH_SOURCE_DIR) / folder))
    if (entry.path().extension() == ".cpp") text += read_file(entry.path());
  return text;
}

TEST(Commands, PanelsNameExistingCommands) {
  const std::regex name(R"re("((?:file|edit|add|simulation|time|view|help)\.[a-z_]+)")re");
  const std::string text = sources_of("ui");
  int named = 0;
  for (std::sregex_iterator found(text.begin(), text.end(), name), end; found != end; ++found, ++named)
    EXPECT_NE(find_command(app::command_registry(), (*found)[1].str()), nullptr) << (*found)[1];
  EXPECT_GT(named, 40);
}

TEST(Commands, MenusShowEveryCommandOfTheirsOnceInItsOrder) {
  for (const Menu menu : {Menu::file, Menu::edit, Menu::add, Menu::simulation, Menu::view, Menu::help}) {
    UiDriver ui(two_walls());
    ui.click(std::string("menu/") + menu_label(menu));
    std::vector<std::string> expected, shown;
    for (const CommandInfo& info : app::command_registry())
      if (info.menu == menu) expected.push_back("menu/" + std::string(info.name));
    for (const WidgetTag& tag : ui.tags)
      if (find_command(app::command_registry(), tag.name.substr(std::min<std::size_t>(5, tag.name.size()))))
        shown.push_back(tag.name);
    std::erase_if(shown, [](const std::string& name) { return !name.starts_with("menu/"); });
    EXPECT_EQ(shown, expected) << menu_label(menu);
    EXPECT_FALSE(expected.empty());
  }
}

TEST(Commands, ShortcutsAreReadAsTheyAreWritten) {
  EXPECT_EQ(shortcut_from_text("Ctrl+Shift+P"), (Shortcut{'P', true, true}));
  EXPECT_EQ(shortcut_from_text("F12"), Shortcut{key::kF12});
  for (const char* wrong : {"", "Ctrl+", "Ctrl", "F13", "ctrl+z", "Shift+Ctrl+Z", "Hyper+A"})
    EXPECT_FALSE(shortcut_from_text(wrong)) << wrong;
}

TEST(Commands, WithNothingToUndoTheButtonIsGrayAndTheKeyIsLeftToTheProgramToRefuse) {
  UiDriver ui(two_walls());
  ui.click("command/edit.undo");
  EXPECT_TRUE(ui.commands.empty());
  EXPECT_FALSE(find_tag(ui.tags, "command/edit.undo")->enabled);
  ui.press_key('Z', true);
  EXPECT_THAT(ui.issued(), ::testing::ElementsAre("edit.undo"));
}

TEST(Commands, KeysTypedIntoAFieldAreNoShortcuts) {
  UiDriver ui(two_walls());
  ui.click("material/density", 1);
  ui.frame();
  ui.press_key('R');
  EXPECT_TRUE(ui.commands.empty());
}

TEST(Commands, QuittingAndScreenshotsWorkWhileTyping) {
  UiDriver ui(two_walls());
  ui.click("material/density", 1);
  ui.frame();
  ASSERT_TRUE(ImGui::GetIO().WantTextInput);
  ui.press_key(key::kF12);
  ui.press_key('Q', true);
  EXPECT_THAT(ui.issued(), ::testing::ElementsAre("file.screenshot", "file.quit"));
}

TEST(Commands, ShortcutsDoNotReachBehindADialog) {
  const std::vector<std::function<void(EditorState&)>> dialogs = {
      [](EditorState& state) { state.work = "Filling with tetrahedra"; },
      [](EditorState& state) {
        state.error = ErrorMessage{"here", "broken", "mend it"};
      },
      [](EditorState& state) {
        state.report = WorkReport{"Added", {}, {}};
      },
      [](EditorState& state) { state.browser.shown = true; },
      [](EditorState& state) { state.show_open = true; },
      [](EditorState& state) {
        state.replacement = Replacement{{.name = "file.save"}, "It is there."};
      },
      [](EditorState& state) { state.recoverable_edits = "scene.json"; },
      [](EditorState& state) { state.show_surface = true; },
      [](EditorState& state) { state.show_preferences = true; },
      [](EditorState& state) { state.asked_steps = 10; },
      [](EditorState& state) { state.palette.shown = true; },
      [](EditorState& state) { state.show_help = true; }};
  for (const auto& show : dialogs) {
    UiDriver ui(two_walls());
    ui.history.change("a", [](Scene& scene) { scene.name = "a"; });
    ui.history.finish();
    show(ui.state);
    for (const CommandInfo& info : app::command_registry()) {
      const Shortcut& shortcut = info.shortcut;
      if (shortcut.key != key::kNone) ui.press_key(shortcut.key, shortcut.ctrl, shortcut.shift, shortcut.alt);
    }
    std::vector<std::string_view> expected = {"file.screenshot", "file.quit"};
    if (ui.state.show_help) expected.push_back("help.show");
    EXPECT_EQ(ui.issued(), expected);
  }
}

TEST(Commands, KeysPressedWhileWorkGoesOnWaitForItInTheirOrder) {
  UiDriver ui(two_walls());
  ui.state.work = "Building bodies";
  for (int i = 0; i < 3; ++i) ui.frame();
  ui.press_key(key::kDelete);
  ui.press_key(key::kDelete);
  ui.press_key('N');
  EXPECT_TRUE(ui.commands.empty());
  EXPECT_EQ(ui.value("work/waiting"), "Then: Delete, Delete, Step");
  ui.state.work.clear();
  ui.frame();
  EXPECT_THAT(ui.issued(), ::testing::ElementsAre("edit.delete")) << "which may make work again";
  ui.state.work = "Building bodies";
  for (int i = 0; i < 3; ++i) ui.frame();
  EXPECT_EQ(ui.issued().size(), 1u);
  ui.state.work.clear();
  ui.press_key('R');
  for (int i = 0; i < 4; ++i) ui.frame();
  EXPECT_THAT(ui.issued(), ::testing::ElementsAre("edit.delete", "edit.delete", "simulation.step", "simulation.reset"));
}

TEST(Commands, KeysAfterAClickThatWorkSwallowedDoNothing) {
  UiDriver ui(two_walls());
  ui.state.work = "Building bodies";
  for (int i = 0; i < 3; ++i) ui.frame();
  ui.press_key(key::kDelete);
  ui.move({5, 5});
  ui.press(0, true);
  ui.press(0, false);
  ui.press_key('N');
  ui.frame();
  EXPECT_EQ(ui.value("work/waiting"), "Then: Delete");
  EXPECT_TRUE(find_tag(ui.tags, "work/lost_click"));
  ui.state.work.clear();
  ui.frame();
  ui.press_key('N');
  for (int i = 0; i < 4; ++i) ui.frame();
  EXPECT_THAT(ui.issued(), ::testing::ElementsAre("edit.delete", "simulation.step"));
}

}  // namespace
}  // namespace griffith::ui
