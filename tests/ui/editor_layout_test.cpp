#include "ui/editor_layout.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <set>

#include "ui/style.h"
#include "ui/widgets.h"
#include "ui_driver.h"

namespace griffith::ui {
namespace {

using ::testing::Field;

const Material& material(const UiDriver& ui, std::size_t body = 0) { return ui.history.scene().bodies[body].material; }

std::vector<CommandId> ids(const UiDriver& ui) {
  std::vector<CommandId> result;
  for (const Command& command : ui.commands) result.push_back(command.id);
  return result;
}

TEST(EditorLayout, AsksForNothingByItself) {
  UiDriver ui(two_walls());
  for (int i = 0; i < 10; ++i) ui.frame();
  EXPECT_TRUE(ui.commands.empty());
  EXPECT_TRUE(ui.history.entries().empty());
  EXPECT_EQ(ui.history.scene(), two_walls());
}

TEST(EditorLayout, WidgetsLieOnTheScreenAndHaveDifferentNames) {
  UiDriver ui(two_walls());
  std::set<std::string> names;
  for (const WidgetTag& tag : ui.tags) {
    EXPECT_TRUE(names.insert(tag.name).second) << tag.name;
    EXPECT_LT(tag.minimum.x, tag.maximum.x) << tag.name;
    EXPECT_GE(tag.minimum.x, 0) << tag.name;
    EXPECT_LE(tag.maximum.x, 1500) << tag.name;
  }
  EXPECT_GT(names.size(), 40u);
}

TEST(EditorLayout, ADragOfASliderIsOneEdit) {
  UiDriver ui(two_walls());
  const Material before = material(ui);
  ui.drag("material/young_modulus", 30);
  EXPECT_NE(material(ui).young_modulus, before.young_modulus);
  ASSERT_EQ(ui.history.entries().size(), 1u);
  EXPECT_EQ(ui.history.entries()[0].label, "Set Young's modulus");
  EXPECT_EQ(material(ui, 1), before);
  ui.history.undo();
  EXPECT_EQ(ui.history.scene(), two_walls());
}

TEST(EditorLayout, EveryMaterialSliderStaysInItsRange) {
  for (const float dx : {-2000.0f, 2000.0f}) {
    UiDriver ui(two_walls());
    for (const char* tag : {"material/young_modulus", "material/poisson_ratio", "material/density",
                            "material/tensile_strength", "material/fracture_toughness"}) {
      ui.drag(tag, dx);
    }
    const Material& m = material(ui);
    EXPECT_GT(m.young_modulus, 0);
    EXPECT_GE(m.poisson_ratio, 0);
    EXPECT_LE(m.poisson_ratio, 0.495);
    EXPECT_GT(m.density, 0);
    EXPECT_GT(m.tensile_strength, 0);
    EXPECT_GT(m.fracture_toughness, 0);
    EXPECT_EQ(ui.history.entries().size(), 5u);
  }
}

TEST(EditorLayout, ValuesCanBeTypedWithTheirUnit) {
  UiDriver ui(two_walls());
  ui.click("material/young_modulus", 1);
  ui.type("20 MPa");
  EXPECT_DOUBLE_EQ(material(ui).young_modulus, 20e6);
  EXPECT_EQ(ui.value("material/young_modulus"), "20 MPa");
  ui.click("material/young_modulus", 1);
  ui.type("35e6");
  EXPECT_DOUBLE_EQ(material(ui).young_modulus, 35e6);
  EXPECT_EQ(ui.history.entries().size(), 2u);
}

TEST(EditorLayout, NonsenseAndEscapeLeaveTheValue) {
  UiDriver ui(two_walls());
  ui.click("material/density", 1);
  ui.type("heavy");
  EXPECT_EQ(ui.value("field_note"),
            "\"heavy\" is not a number of kg/m³. 0.01 kg/m³ to 1e+06 kg/m³ is possible. The value stays.");
  ui.click("material/density", 1);
  ui.press_key(key::kEscape);
  EXPECT_EQ(ui.history.scene(), two_walls());
  EXPECT_TRUE(ui.history.entries().empty());
}

TEST(EditorLayout, PresetReplacesTheWholeMaterialOfTheSelectedBody) {
  UiDriver ui(two_walls());
  ui.click("bodies/1");
  EXPECT_EQ(ui.state.selected_body, 1);
  const Material& preset = material_presets().front().material;
  ui.click("material/preset");
  ui.click("material/preset/" + preset.name);
  EXPECT_EQ(material(ui, 1), preset);
  EXPECT_EQ(material(ui, 0), Material());
  EXPECT_LE(ui.history.entries().size(), 1u);
}

TEST(EditorLayout, APresetWhoseValuesWereEditedIsCalledSo) {
  UiDriver ui(two_walls());
  EXPECT_EQ(ui.value("material/preset"), "brick");
  ui.drag("material/density", 40);
  EXPECT_EQ(ui.value("material/preset"), "brick (edited)");
  ui.history.undo();
  ui.frame();
  EXPECT_EQ(ui.value("material/preset"), "brick");
  ui.history.change("name", [](Scene& scene) { scene.bodies[0].material.name = "mine"; });
  ui.drag("material/density", 40);
  EXPECT_EQ(ui.value("material/preset"), "mine");
}

TEST(EditorLayout, CriterionChoosesItsOwnResistance) {
  UiDriver ui(two_walls());
  ui.click("material/criterion");
  ui.click("material/criterion/separation force");
  EXPECT_EQ(material(ui).criterion, FractureCriterion::separation_force);
  EXPECT_NE(find_tag(ui.tags, "material/separation_toughness"), nullptr);
  EXPECT_EQ(find_tag(ui.tags, "material/tensile_strength"), nullptr);
}

TEST(EditorLayout, ButtonsIssueTheirCommands) {
  UiDriver ui(two_walls());
  ui.click("command/simulation.step");
  ui.click("command/simulation.run");
  ui.click("command/simulation.reset");
  EXPECT_THAT(ids(ui), ::testing::ElementsAre(CommandId::step, CommandId::toggle_run, CommandId::reset));
}

TEST(EditorLayout, MenusIssueTheirCommands) {
  UiDriver ui(two_walls());
  ui.click("menu/Simulation");
  ui.click("menu/simulation.step");
  EXPECT_THAT(ids(ui), ::testing::ElementsAre(CommandId::step));
}

TEST(EditorLayout, EveryShortcutIssuesItsCommandOnce) {
  for (const CommandInfo& info : command_registry()) {
    if (info.shortcut.key == key::kNone) continue;
    UiDriver ui(two_walls());
    ui.history.change("a", [](Scene& scene) { scene.name = "a"; });
    ui.history.finish();
    ui.history.change("b", [](Scene& scene) { scene.name = "b"; });
    ui.history.undo();  // now there is something to undo and to redo
    ui.state.view.range = Vec2(0, 1);
    ui.press_key(info.shortcut.key, info.shortcut.ctrl, info.shortcut.shift);
    EXPECT_THAT(ids(ui), ::testing::ElementsAre(info.id)) << info.name;
  }
}

TEST(EditorLayout, CommandsHaveDifferentNamesAndShortcuts) {
  std::set<std::string_view> names, shortcuts;
  for (const CommandInfo& info : command_registry()) {
    EXPECT_TRUE(names.insert(info.name).second) << info.name;
    EXPECT_TRUE(info.shortcut_text.empty() || shortcuts.insert(info.shortcut_text).second) << info.shortcut_text;
    EXPECT_EQ(info.shortcut_text.empty(), info.shortcut.key == key::kNone) << info.name;
    EXPECT_FALSE(info.hint.empty()) << info.name;
    EXPECT_EQ(command_info(info.id).name, info.name);
  }
}

TEST(EditorLayout, NothingToUndoIssuesNoUndo) {
  UiDriver ui(two_walls());
  ui.click("command/edit.undo");
  ui.press_key('Z', true);
  EXPECT_TRUE(ui.commands.empty());
  EXPECT_FALSE(find_tag(ui.tags, "command/edit.undo")->enabled);
}

TEST(EditorLayout, KeysTypedIntoAFieldAreNoShortcuts) {
  UiDriver ui(two_walls());
  ui.click("material/density", 1);
  ui.frame();
  ui.press_key('R');
  EXPECT_TRUE(ui.commands.empty());
}

TEST(EditorLayout, QuittingAndScreenshotsWorkWhileTyping) {
  UiDriver ui(two_walls());
  ui.click("material/density", 1);
  ui.frame();
  ASSERT_TRUE(ImGui::GetIO().WantTextInput);
  ui.press_key(key::kF12);
  ui.press_key('Q', true);
  EXPECT_THAT(ids(ui), ::testing::ElementsAre(CommandId::screenshot, CommandId::quit));
}

TEST(EditorLayout, ShortcutsDoNotReachBehindADialog) {
  const std::vector<std::function<void(EditorState&)>> dialogs = {
      [](EditorState& state) { state.work = "Filling with tetrahedra"; },
      [](EditorState& state) {
        state.error = ErrorMessage{"here", "broken", "mend it"};
      },
      [](EditorState& state) {
        state.report = WorkReport{"Added", {}, {}};
      },
      [](EditorState& state) { state.show_open = true; },
      [](EditorState& state) {
        state.replacement = Replacement{{.id = CommandId::save}, "It is there."};
      },
      [](EditorState& state) { state.left_edits = "scene.json"; },
      [](EditorState& state) { state.show_surface = true; },
      [](EditorState& state) { state.show_help = true; }};
  for (const auto& show : dialogs) {
    UiDriver ui(two_walls());
    ui.history.change("a", [](Scene& scene) { scene.name = "a"; });
    ui.history.finish();
    show(ui.state);
    for (const CommandInfo& info : command_registry()) {
      if (info.shortcut.key != key::kNone) ui.press_key(info.shortcut.key, info.shortcut.ctrl, info.shortcut.shift);
    }
    std::vector<CommandId> expected = {CommandId::screenshot};
    if (ui.state.show_help) expected.push_back(CommandId::help);
    expected.push_back(CommandId::quit);
    EXPECT_EQ(ids(ui), expected);
  }
}

TEST(EditorLayout, TheWayToWhereTheButtonWentDownIsNoDrag) {
  UiDriver ui(two_walls());
  const ImVec2 place = ui.find("viewport");
  ui.move({place.x - 200, place.y - 100});
  ImGui::GetIO().MousePos = place;  // a slow frame sees the move and the press at once
  ui.press(0, true);
  EXPECT_EQ(ui.state.camera_motion.yaw, 0);
  EXPECT_EQ(ui.state.camera_motion.pitch, 0);
  ui.move({place.x + 10, place.y});
  EXPECT_LT(ui.state.camera_motion.yaw, 0);
}

TEST(EditorLayout, TheMassOfAShotFollowsItsDensityOnlyWhileThatIsShown) {
  Scene scene = two_walls();
  UiDriver ui(scene);
  ImGui::GetIO().DisplaySize = {1500, 4000};
  ui.state.shot.density = 2650;
  for (int i = 0; i < 3; ++i) ui.frame();
  EXPECT_EQ(find_tag(ui.tags, "projectile/mass"), nullptr);
  ui.click("projectile/density", 1);
  ui.type("7850");
  EXPECT_EQ(ui.state.shot.density, 7850);
  ui.click("projectile/by_density");
  EXPECT_FALSE(ui.state.shot.density);
  ui.click("projectile/mass", 1);
  ui.type("3 kg");
  EXPECT_EQ(ui.state.shot.mass, 3);
}

TEST(EditorLayout, MouseInTheViewMovesTheCamera) {
  UiDriver ui(two_walls());
  ui.drag("viewport", 100, 50);
  EXPECT_LT(ui.state.camera_motion.yaw, 0);
  EXPECT_GT(ui.state.camera_motion.pitch, 0);
  EXPECT_EQ(ui.state.camera_motion.pan_right, 0);
  ui.state.camera_motion = {};
  ui.drag("viewport", 100, 50, 2);
  EXPECT_LT(ui.state.camera_motion.pan_right, 0);
  EXPECT_GT(ui.state.camera_motion.pan_up, 0);
  EXPECT_EQ(ui.state.camera_motion.yaw, 0);
  ImGui::GetIO().MouseWheel = 1;
  ui.frame();
  EXPECT_LT(ui.state.camera_motion.zoom, 1);
  EXPECT_TRUE(ui.commands.empty());  // a drag is no click
}

TEST(EditorLayout, ClicksInTheViewPickAndFireAtTheCursor) {
  UiDriver ui(two_walls());
  ui.click("viewport");
  ui.click("viewport", 1);
  ASSERT_THAT(ids(ui), ::testing::ElementsAre(CommandId::pick, CommandId::fire));
  for (const Command& command : ui.commands) {
    EXPECT_NEAR(command.cursor.x(), 0.5, 0.01);
    EXPECT_NEAR(command.cursor.y(), 0.5, 0.01);
  }
}

TEST(EditorLayout, FireKeyAimsAtTheCursor) {
  UiDriver ui(two_walls());
  const ImVec2 low = ui.state.viewport_minimum, size = ui.state.viewport_size;
  ui.move({low.x + 0.25f * size.x, low.y + 0.75f * size.y});
  ui.press_key('F');
  ASSERT_THAT(ids(ui), ::testing::ElementsAre(CommandId::fire));
  EXPECT_NEAR(ui.commands[0].cursor.x(), 0.25, 0.01);
  EXPECT_NEAR(ui.commands[0].cursor.y(), 0.75, 0.01);
}

TEST(EditorLayout, SpeedStaysBetweenAThousandthAndOne) {
  UiDriver ui(two_walls());
  ui.drag("toolbar/speed", -3000);
  EXPECT_NEAR(ui.state.speed, 0.001, 1e-6);
  ui.drag("toolbar/speed", 3000);
  EXPECT_NEAR(ui.state.speed, 1, 1e-6);
}

TEST(EditorLayout, ErrorIsShownUntilClosed) {
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

TEST(EditorLayout, AnErrorIsRedUntilTheUserGoesOn) {
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

TEST(EditorLayout, EscapeClosesListsAndMenusAndNotTheDialogAroundThem) {
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

TEST(EditorLayout, EscapeInAnUntouchedFieldLeavesTheDialog) {
  UiDriver ui(two_walls());
  ui.state.save_as = save_target("a.json");
  for (int i = 0; i < 3; ++i) ui.frame();
  ASSERT_TRUE(ImGui::GetIO().WantTextInput);
  ui.press_key(key::kEscape);
  EXPECT_FALSE(ui.state.save_as);
}

TEST(EditorLayout, OpenDialogTakesATypedPath) {
  UiDriver ui(two_walls());
  ui.state.show_open = true;
  for (int i = 0; i < 3; ++i) ui.frame();
  ui.click("open/path");
  ui.type("a/b.json");
  ASSERT_THAT(ids(ui), ::testing::ElementsAre(CommandId::open));
  EXPECT_EQ(ui.commands[0].path, "a/b.json");
  EXPECT_FALSE(ui.state.show_open);
}

TEST(EditorLayout, ScenesOfTheSameNameAreToldApartByTheirFolder) {
  UiDriver ui(two_walls());
  const std::vector<std::filesystem::path> files = {"a/table.json", "a/wall.json", "b/wall.json"};
  ui.input.scene_files = files;
  ui.state.show_open = true;
  for (int i = 0; i < 3; ++i) ui.frame();
  EXPECT_EQ(ui.value("open/table"), "table");
  ui.click("open/wall (b)");
  ASSERT_THAT(ids(ui), ::testing::ElementsAre(CommandId::open));
  EXPECT_EQ(ui.commands[0].path, "b/wall.json");
}

TEST(EditorLayout, SaveDialogTakesATypedName) {
  UiDriver ui(two_walls());
  ui.state.save_as = save_target("/somewhere/walls.json");
  for (int i = 0; i < 3; ++i) ui.frame();
  EXPECT_EQ(ui.value("save/path"), "/somewhere/walls.json");
  ui.type("../else/table");  // it has the focus, and what was there is replaced
  ASSERT_THAT(ids(ui), ::testing::ElementsAre(CommandId::save));
  EXPECT_EQ(ui.commands[0].path, "/else/table.json");
  EXPECT_FALSE(ui.state.save_as);
}

TEST(EditorLayout, LongLabelsEndInDotsBeforeTheirWidget) {
  UiDriver ui(two_walls());
  ImGui::NewFrame();
  const std::string text = "Größte Verzerrung μ…ω of a rather long name";
  for (float width = 400; width > 20; width -= 3) {
    const std::string shown = fitted(text, width);
    EXPECT_LE(ImGui::CalcTextSize(shown.c_str()).x, width);
    EXPECT_EQ(shown == text, ImGui::CalcTextSize(text.c_str()).x <= width);
    if (shown == text) continue;
    const std::string kept = shown.substr(0, shown.size() - std::string("…").size());
    EXPECT_TRUE(text.starts_with(kept));
    EXPECT_NE(text[kept.size()] & 0xc0, 0x80) << "within a letter";
  }
  ImGui::EndFrame();
}

TEST(EditorLayout, SceneWithoutBodiesIsShownToo) {
  UiDriver ui({});
  ui.frame();
  EXPECT_EQ(find_tag(ui.tags, "material/density"), nullptr);
}

TEST(EditorLayout, RandomClicksAndKeysBreakNothing) {
  UiDriver ui(two_walls());
  std::uint32_t seed = 12345;
  const auto random = [&seed](std::uint32_t below) {
    seed = seed * 1664525u + 1013904223u;
    return (seed >> 8) % below;
  };
  for (int i = 0; i < 1500; ++i) {
    ui.move({static_cast<float>(random(1500)), static_cast<float>(random(940))});
    ui.press(static_cast<int>(random(3)), random(2) == 0);
    if (random(10) == 0) ImGui::GetIO().AddInputCharacter('0' + random(10));
    ASSERT_LE(material(ui).poisson_ratio, 0.495);
    ASSERT_GT(material(ui).young_modulus, 0);
    ASSERT_GE(ui.state.shot.count, 1);
    ASSERT_GT(ui.state.speed, 0);
  }
}

}  // namespace
}  // namespace griffith::ui
