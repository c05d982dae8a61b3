#include "ui/panels/editor_layout.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>
#include <sstream>

#include "ui/widgets/widgets.h"
#include "ui_driver.h"

namespace griffith::ui {
namespace {

const Material& material(const UiDriver& ui, std::size_t body = 0) { return ui.history.scene().bodies[body].material; }

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

TEST(EditorLayout, ADragOfANumberIsOneEdit) {
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

TEST(EditorLayout, EveryMaterialNumberStaysInItsRange) {
  for (const float dx : {-9000.0f, 9000.0f}) {
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
  ui.type("35");
  EXPECT_DOUBLE_EQ(material(ui).young_modulus, 35e6);
  EXPECT_EQ(ui.history.entries().size(), 2u);
}

TEST(EditorLayout, ACompressiveStrengthIsGivenWithinWhatAFileTakes) {
  UiDriver ui(two_walls());
  const double tension = material(ui).tensile_strength;
  ui.click("material/criterion");
  ui.click("material/criterion/strength surface");
  EXPECT_DOUBLE_EQ(*material(ui).compressive_strength, 10 * tension);
  ui.click("material/compressive_strength", 1);
  ui.type("1 Pa");
  EXPECT_DOUBLE_EQ(*material(ui).compressive_strength, tension) << "it is at least the tensile one";
  ui.click("material/tensile_strength", 1);
  ui.type("10 GPa");
  EXPECT_DOUBLE_EQ(material(ui).tensile_strength, tension);
  ui.click("material/criterion");
  ui.click("material/criterion/strength");
  EXPECT_EQ(material(ui).compressive_strength, std::nullopt);
}

TEST(EditorLayout, NonsenseAndEscapeLeaveTheValue) {
  UiDriver ui(two_walls());
  ui.click("material/density", 1);
  ui.type("heavy");
  EXPECT_EQ(ui.value("field_note"),
            "\"heavy\" is not a number of kg/m³. Allowed: 0.01 kg/m³ to 1e+06 kg/m³. The value was not changed.");
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

TEST(EditorLayout, AClickOnTheLabelTakesAValueBackToThePreset) {
  UiDriver ui(two_walls());
  const double density = material(ui).density;
  ui.click("label/Density");
  EXPECT_EQ(ui.history.scene(), two_walls()) << "nothing to take back";
  ui.drag("material/density", 40);
  ASSERT_NE(material(ui).density, density);
  ui.click("label/Density");
  EXPECT_EQ(material(ui).density, density);
  EXPECT_EQ(ui.value("material/preset"), "brick");
  ui.history.undo();
  EXPECT_NE(material(ui).density, density) << "one entry of the history";
}

TEST(EditorLayout, AMaterialIsKeptUnderANameForOtherBodies) {
  UiDriver ui(two_walls());
  ui.drag("material/density", 40);
  const Material edited = material(ui);
  ui.click("material/keep_as");
  ui.type("heavy brick");
  EXPECT_EQ(ui.value("material/preset"), "heavy brick");
  ASSERT_EQ(ui.history.scene().materials.size(), 1u);
  EXPECT_EQ(ui.history.scene().materials[0].density, edited.density);
  ui.click("bodies/1");
  ui.click("material/preset");
  ui.click("material/preset/heavy brick");
  EXPECT_EQ(material(ui, 1), ui.history.scene().materials[0]);
  ui.drag("material/density", -60);
  EXPECT_EQ(ui.value("material/preset"), "heavy brick (edited)");
  ui.click("label/Density");
  EXPECT_EQ(material(ui, 1), ui.history.scene().materials[0]);
  ui.click("material/forget");
  EXPECT_TRUE(ui.history.scene().materials.empty());
  EXPECT_EQ(material(ui, 1).density, edited.density) << "bodies keep theirs";
}

TEST(EditorLayout, APresetsNameIsNotTakenForAnotherMaterial) {
  UiDriver ui(two_walls());
  const Scene before = ui.history.scene();
  for (const std::string name : {"granite", "soda_lime_glass"}) {
    ui.click("material/keep_as");
    ui.type(name);
    EXPECT_EQ(ui.history.scene(), before);
    EXPECT_NE(ui.state.field_note.text.find(name), std::string::npos);
  }
}

TEST(EditorLayout, CriterionChoosesItsOwnResistance) {
  UiDriver ui(two_walls());
  ui.click("material/criterion");
  ui.click("material/criterion/separation force");
  EXPECT_EQ(material(ui).criterion, FractureCriterion::separation_force);
  EXPECT_NE(find_tag(ui.tags, "material/separation_toughness"), nullptr);
  EXPECT_EQ(find_tag(ui.tags, "material/tensile_strength"), nullptr);
}

TEST(EditorLayout, TheWayToWhereTheButtonWentDownIsNoDrag) {
  UiDriver ui(two_walls());
  const ImVec2 place = ui.find("viewport");
  ui.move({place.x - 200, place.y - 100});
  ui.queue.move(place);  // a slow frame sees the move and the press at once
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

TEST(EditorLayout, PreferencesTurnTheMouseRound) {
  UiDriver ui(two_walls());
  ui.drag("viewport", 0, 50);
  const float pitch = ui.state.camera_motion.pitch;
  ui.state.preferences.mouse_speed = 2;
  ui.state.preferences.invert_orbit = ui.state.preferences.invert_zoom = true;
  ui.state.camera_motion = {};
  ui.drag("viewport", 0, 50);
  EXPECT_NEAR(ui.state.camera_motion.pitch, -2 * pitch, 1e-5);
  ImGui::GetIO().MouseWheel = 1;
  ui.frame();
  EXPECT_GT(ui.state.camera_motion.zoom, 1);
}

TEST(EditorLayout, ClicksInTheViewPickAndFireAtTheCursor) {
  UiDriver ui(two_walls());
  ui.click("viewport");
  ui.click("viewport", 1);
  ASSERT_THAT(ui.issued(), ::testing::ElementsAre("view.pick", "simulation.fire"));
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
  ASSERT_THAT(ui.issued(), ::testing::ElementsAre("simulation.fire"));
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

TEST(EditorLayout, ShowsTheDurationOfAStepOnceOneWasMade) {
  UiDriver ui(two_walls());
  ui.frame();
  EXPECT_EQ(find_tag(ui.tags, "toolbar/step_time"), nullptr);
  ui.input.step_milliseconds = 0.012;
  ui.frame();
  EXPECT_EQ(ui.value("toolbar/step_time"), "0.012 ms/step");
  ui.input.step_milliseconds = 12.34;
  ui.frame();
  EXPECT_EQ(ui.value("toolbar/step_time"), "12.3 ms/step");
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

TEST(EditorLayout, LinesEndAtSpacesAndNumbersStayWhole) {
  UiDriver ui(two_walls());
  ImGui::NewFrame();
  const std::string text = "Broke at 0.186 s (step 23):\nthe load of 1.79 MPa was 196.5 % of it. Extraordinarily.";
  for (float width = 1; width < 800; width += 13) {
    const std::string lines = broken_into_lines(text, width);
    ASSERT_EQ(lines.size(), text.size());
    for (std::size_t i = 0; i < text.size(); ++i)
      EXPECT_TRUE(lines[i] == text[i] || (lines[i] == '\n' && text[i] == ' ')) << lines;
    std::istringstream stream(lines);
    for (std::string line; std::getline(stream, line);)
      EXPECT_TRUE(ImGui::CalcTextSize(line.c_str()).x <= width || line.find(' ') == std::string::npos) << line;
  }
  EXPECT_EQ(broken_into_lines(text, 1e4f), text);
  EXPECT_EQ(broken_into_lines("", 10), "");
  ImGui::EndFrame();
}

TEST(EditorLayout, TheReasonOfAStopLeavesTheLegendFree) {
  UiDriver ui(two_walls());
  ImGui::GetIO().DisplaySize = {1280, 720};
  const std::vector<std::uint8_t> colors(4 * 256, 255);
  ui.input.views[0].legend.emplace();
  ui.input.views[0].legend->title = "von Mises stress";
  ui.input.views[0].legend->colors = colors;
  ui.state.stop = Stop{"Node 12 cracks in the next step, at 161 % of its resistance.", NodeId(0), {}};
  for (int i = 0; i < 4; ++i) ui.frame();
  const ScreenArea picture{
      ui.state.viewport_minimum,
      {ui.state.viewport_minimum.x + ui.state.viewport_size.x, ui.state.viewport_minimum.y + ui.state.viewport_size.y}};
  ASSERT_TRUE(legend_fits(picture, 1));
  const ScreenArea legend =
      legend_card(*ui.input.views[0].legend, LegendCorner::upper_right, ui.input.fonts, picture, 1);
  const WidgetTag* reason = find_tag(ui.tags, "time/stopped");
  ASSERT_TRUE(reason);
  EXPECT_LE(reason->maximum.x, legend.minimum.x);
  EXPECT_GE(reason->minimum.x, picture.minimum.x);
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
