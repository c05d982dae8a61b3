// What is typed into numbers, and what they say of it.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "ui/widgets/field_range.h"
#include "ui/widgets/number_field.h"
#include "ui_driver.h"

namespace griffith::ui {
namespace {

const Material& edited_material(const UiDriver& ui) { return ui.history.scene().bodies[0].material; }

TEST(NumberFields, TypedPoissonRatioStaysBelowOneHalfAndSaysSo) {
  for (const char* text : {"0.5", "0.7", "1e9"}) {
    UiDriver ui(two_walls());
    ui.click("material/poisson_ratio", 1);
    ui.type(text);
    EXPECT_EQ(edited_material(ui).poisson_ratio, 0.495) << text;
    EXPECT_THAT(ui.value("field_note"), ::testing::HasSubstr("is more than 0.495 and was set to it")) << text;
    EXPECT_EQ(ui.state.field_note.tag, "material/poisson_ratio");
  }
}

TEST(NumberFields, TheMeaningOfWhatIsTypedStandsBesideIt) {
  UiDriver ui(two_walls());
  ui.click("projectile/radius", 1);
  const auto meaning_of = [&ui](const std::string& text) {
    ui.press_key('A', true);
    for (const char letter : text) ImGui::GetIO().AddInputCharacter(static_cast<unsigned char>(letter));
    ui.frame();
    return ui.value("typed_meaning");
  };
  EXPECT_EQ(meaning_of("100"), "= 100 mm");
  EXPECT_EQ(meaning_of("12 mm"), "= 12 mm");
  EXPECT_EQ(meaning_of("3e5 m"), "= 10 km: 100 µm to 10 km is possible.");
  EXPECT_EQ(meaning_of("wide"), "\"wide\" is not a number of m. 100 µm to 10 km is possible.");
  ui.press_key(key::kEscape);
  EXPECT_EQ(find_tag(ui.tags, "typed_meaning"), nullptr);
  EXPECT_EQ(find_tag(ui.tags, "field_note"), nullptr);
}

/// Types a number far beyond what the field takes; the value that it then has.
double typed_beyond(UiDriver& ui, const std::string& name, const char* text, double& (*member)(Material&)) {
  ui.click("material/" + name, 1);
  ui.type(text);
  Material taken = edited_material(ui);
  EXPECT_NE(find_tag(ui.tags, "field_note"), nullptr) << name;
  return member(taken);
}

TEST(NumberFields, PanelsAndFilesShareOneRange) {
  const std::pair<const char*, double& (*)(Material&)> members[] = {
      {"young_modulus", [](Material& m) -> double& { return m.young_modulus; }},
      {"poisson_ratio", [](Material& m) -> double& { return m.poisson_ratio; }},
      {"density", [](Material& m) -> double& { return m.density; }},
      {"tensile_strength", [](Material& m) -> double& { return m.tensile_strength; }},
      {"fracture_toughness", [](Material& m) -> double& { return m.fracture_toughness; }}};
  for (const auto& [name, member] : members) {
    UiDriver ui(two_walls());
    const Numbers range = range_of<Material>(name);
    EXPECT_EQ(typed_beyond(ui, name, "1e30", member), range.maximum) << name;
    EXPECT_EQ(typed_beyond(ui, name, "-1e30", member), range.minimum) << name;
  }
  UiDriver ui(two_walls());
  ui.click("material/young_modulus", 1);
  ui.type("5000 GPa");
  EXPECT_EQ(edited_material(ui).young_modulus, 5e12) << "files take it";
  EXPECT_EQ(find_tag(ui.tags, "field_note"), nullptr);
}

/// Tags of all number fields of the panels.
const std::vector<std::string>& number_tags(const UiDriver& ui) { return ui.state.number_tags; }

Scene scene_of_many_fields() {
  Scene scene = two_walls();
  scene.bodies[0].supports.resize(1);
  scene.bodies[0].loads.resize(1);
  scene.projectiles.resize(1);
  scene.cameras.resize(1);
  return scene;
}

/// A scene of which the panels show what belongs to entry number `i` of the outliner.
void choose_entry(UiDriver& ui, int i) {
  constexpr EntryKind kKinds[] = {EntryKind::body, EntryKind::support, EntryKind::load, EntryKind::projectile,
                                  EntryKind::camera};
  ui.state.entries = {{kKinds[i], 0}};
  ui.state.open_sections = true;
  for (int frame = 0; frame < 4; ++frame) ui.frame();
}

/// Scrolls to a field.
void seek(UiDriver& ui, const std::string& tag) {
  ui.state.sought = {tag, 3};
  for (int frame = 0; frame < 4; ++frame) ui.frame();
}

TEST(NumberFields, AClickOnAnyOpensItAndNeverChangesIt) {
  int fields = 0;
  for (int entry = 0; entry < 5; ++entry) {
    UiDriver ui(scene_of_many_fields());
    choose_entry(ui, entry);
    const Scene before = ui.history.scene();
    const ProjectileBurst shot = ui.state.shot;
    const std::vector<std::string> tags = number_tags(ui);
    for (const std::string& tag : tags) {
      seek(ui, tag);
      ui.click(tag);
      ui.frame();
      EXPECT_EQ(ui.state.number_entry.tag, tag);
      EXPECT_TRUE(ui.state.number_entry.typing) << tag;
      ui.press_key(key::kEnter);
      ui.frame();
      EXPECT_EQ(ui.state.number_entry.tag, "") << tag;
      ++fields;
    }
    EXPECT_EQ(ui.history.scene(), before);
    EXPECT_EQ(ui.state.shot, shot);
    EXPECT_TRUE(ui.history.entries().empty());
  }
  EXPECT_GT(fields, 60);
}

TEST(NumberFields, ABareNumberIsInTheUnitShown) {
  UiDriver ui(two_walls());
  ui.history.change("set up", [](Scene& scene) {
    scene.bodies[0].position = Vec3(0.01, 0, 0);
    scene.bodies[0].material.tensile_strength = 2e6;
  });
  ui.history.finish();
  choose_entry(ui, 0);
  ASSERT_EQ(ui.value("material/tensile_strength"), "2 MPa");
  ui.click("material/tensile_strength");
  ui.type("3");
  EXPECT_DOUBLE_EQ(edited_material(ui).tensile_strength, 3e6);
  ASSERT_EQ(ui.value("projectile/radius"), "200 mm");
  seek(ui, "projectile/radius");
  ui.click("projectile/radius");
  ui.type("100");
  EXPECT_DOUBLE_EQ(ui.state.shot.radius, 0.1);
  ASSERT_EQ(ui.value("body/position/0"), "10");
  seek(ui, "body/position/0");
  ui.click("body/position/0");
  ui.type("604");
  EXPECT_DOUBLE_EQ(ui.history.scene().bodies[0].position.x(), 0.604);
}

TEST(NumberFields, TheUnitStaysWhileTypingAndDragging) {
  UiDriver ui(two_walls());
  ui.click("projectile/radius");
  for (const char letter : std::string("5 m")) ImGui::GetIO().AddInputCharacter(static_cast<unsigned char>(letter));
  for (int i = 0; i < 6; ++i) ui.frame();
  EXPECT_EQ(ui.state.number_entry.prefix.symbol, "m");
  ui.press_key(key::kEscape);
  ui.move(ui.find("projectile/radius"));
  ui.press(0, true);
  ui.move({ui.find("projectile/radius").x + 400, ui.find("projectile/radius").y});
  EXPECT_GT(ui.state.shot.radius, 1);
  EXPECT_TRUE(ui.value("projectile/radius").ends_with(" mm")) << ui.value("projectile/radius");
  ui.press(0, false);
  ui.frame();
  EXPECT_TRUE(ui.value("projectile/radius").ends_with(" m")) << ui.value("projectile/radius");
}

TEST(NumberFields, ADragIsRelativeAndFine) {
  const NumberField modulus = {
      .tag = "", .label = "", .numbers = between(1, 1e13, "Pa"), .low = 1e4, .high = 1e12, .logarithmic = true};
  const NumberField ratio = {.tag = "", .label = "", .numbers = between(0, 0.495, "-")};
  const NumberField count = {.tag = "", .label = "", .numbers = between(1, 10000, ""), .whole = true};
  for (const double start : {1e5, 15e9, 7e11}) {
    EXPECT_EQ(dragged_value(modulus, start, 0, false), start);
    EXPECT_NEAR(dragged_value(modulus, start, 1, false) / start, 1.005, 1e-4);
    EXPECT_NEAR(dragged_value(modulus, dragged_value(modulus, start, 40, false), -40, false) / start, 1, 1e-12);
    EXPECT_LT(dragged_value(modulus, start, 40, false) / start, 1.25);
  }
  EXPECT_EQ(dragged_value(modulus, 15e9, 1e5, false), 1e13);
  EXPECT_NEAR(dragged_value(ratio, 0.2, 1, false), 0.201, 1e-3);
  EXPECT_EQ(dragged_value(ratio, 0.2, -1e4, false), 0);
  EXPECT_EQ(dragged_value(count, 1, 10, false), 2);
  EXPECT_EQ(dragged_value(modulus, 15e9, 7, true), 16e9);
}

TEST(NumberFields, ShiftIsFinerAndCtrlCoarser) {
  const auto dragged = [](bool shift, bool ctrl) {
    UiDriver ui(two_walls());
    const double before = edited_material(ui).density;
    ImGui::GetIO().KeyShift = shift;
    ImGui::GetIO().KeyCtrl = ctrl;
    ui.queue.move(ui.find("material/density"));
    ui.play();
    ImGui::GetIO().KeysDown[key::kLeftShift] = shift;
    ImGui::GetIO().KeysDown[key::kLeftControl] = ctrl;
    ui.press(0, true);
    ImGui::GetIO().KeyShift = shift, ImGui::GetIO().KeyCtrl = ctrl;
    const ImVec2 place = ui.find("material/density");
    ImGui::GetIO().MousePos = {place.x + 20, place.y};
    ui.frame();
    return std::log(edited_material(ui).density / before);
  };
  const double plain = dragged(false, false), fine = dragged(true, false), coarse = dragged(false, true);
  EXPECT_GT(plain, 0);
  EXPECT_NEAR(fine / plain, 0.1, 0.02);
  EXPECT_NEAR(coarse / plain, 10, 1.5);
}

TEST(NumberFields, EscapeInADragRestoresTheValue) {
  UiDriver ui(two_walls());
  const Scene before = ui.history.scene();
  ui.move(ui.find("material/density"));
  ui.press(0, true);
  ui.move({ui.find("material/density").x + 60, ui.find("material/density").y});
  EXPECT_NE(ui.history.scene(), before);
  ui.press_key(key::kEscape);
  EXPECT_EQ(ui.history.scene(), before);
  ui.press(0, false);
  ui.frame();
  EXPECT_EQ(ui.history.scene(), before);
}

TEST(NumberFields, TabTakesTheNumberAndOpensTheNextField) {
  UiDriver ui(two_walls());
  choose_entry(ui, 0);
  const auto type_and_tab = [&ui](const char* text, bool back) {
    ui.press_key('A', true);
    ui::type(ui.queue, text);
    ui::press(ui.queue, {key::kTab, false, back});
    ui.play();
    for (int i = 0; i < 4; ++i) ui.frame();
  };
  seek(ui, "body/position/0");
  ui.click("body/position/0");
  type_and_tab("1 m", false);
  EXPECT_EQ(ui.state.number_entry.tag, "body/position/1");
  type_and_tab("2 m", false);
  EXPECT_EQ(ui.state.number_entry.tag, "body/position/2");
  type_and_tab("3 m", true);
  EXPECT_EQ(ui.state.number_entry.tag, "body/position/1");
  EXPECT_EQ(ui.history.scene().bodies[0].position, Vec3(1, 2, 3));
}

TEST(NumberFields, TheWheelScrollsAndChangesNothing) {
  UiDriver ui(two_walls());
  const Scene before = ui.history.scene();
  scroll(ui.queue, ui.find("material/density"), 2);
  ui.play();
  EXPECT_EQ(ui.history.scene(), before);
}

TEST(NumberFields, VectorsOfAFormShareOneUnit) {
  Scene scene = two_walls();
  scene.cameras.resize(1);
  scene.cameras[0].position = Vec3(0.004, 0.003, 0.008);
  scene.cameras[0].target = Vec3(0, 5, 0);
  UiDriver ui(scene);
  choose_entry(ui, 4);
  std::string labels;
  for (const WidgetTag& tag : ui.tags)
    if (tag.name.starts_with("label/")) labels += tag.value + "; ";
  EXPECT_THAT(labels, ::testing::HasSubstr("Position [m];"));
  EXPECT_THAT(labels, ::testing::HasSubstr("Target [m];"));
}

TEST(NumberFields, ADoubleClickAtTenPicturesASecondOpensTheField) {
  UiDriver ui(two_walls());
  ImGui::GetIO().DeltaTime = 0.1F;
  ui.click("material/density");
  ui.click("material/density");
  EXPECT_EQ(ui.state.number_entry.tag, "material/density");
  EXPECT_EQ(ui.history.scene(), two_walls());
}

TEST(NumberFields, CountsSayWhatTheyTake) {
  UiDriver ui(two_walls());
  ui.click("projectile/count");
  ui.press_key('A', true);
  ui.type("20000");
  EXPECT_EQ(ui.state.shot.count, 10000);
  EXPECT_THAT(ui.value("field_note"), ::testing::HasSubstr("1 to 10000 is possible"));
}

}  // namespace
}  // namespace griffith::ui
