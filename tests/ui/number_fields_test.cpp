// What is typed into numbers, and what they say of it.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/random_values.h"
#include "ui/model/number_drag.h"
#include "ui/widgets/field_range.h"
#include "ui_driver.h"

namespace griffith::ui {
namespace {

/// Shows the panels with all their sections in a window that has room for them.
void open_all_sections(UiDriver& ui) {
  ImGui::GetIO().DisplaySize = {1500, 6000};
  ui.state.open_sections = true;
  for (int i = 0; i < 3; ++i) ui.frame();
}

const Material& edited_material(const UiDriver& ui) { return ui.history.scene().bodies[0].material; }

TEST(NumberFields, TypedPoissonRatioStaysBelowOneHalfAndSaysSo) {
  for (const char* text : {"0.5", "0.7", "1e9"}) {
    UiDriver ui(two_walls());
    ui.click("material/poisson_ratio", 1);
    ui.type(text);
    EXPECT_EQ(edited_material(ui).poisson_ratio, 0.495) << text;
    EXPECT_THAT(ui.value("field_note"), ::testing::HasSubstr("is above the maximum 0.495 and was set to it")) << text;
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
  EXPECT_EQ(meaning_of("0.1"), "= 0.1 mm");
  EXPECT_EQ(meaning_of("12 mm"), "= 12 mm");
  EXPECT_EQ(meaning_of("3e5 m"), "= 10000000 mm. Allowed: 100 µm to 10 km.");
  EXPECT_EQ(meaning_of("wide"), "\"wide\" is not a number of mm. Allowed: 100 µm to 10 km.");
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

TEST(NumberFields, CountsSayWhatTheyTake) {
  UiDriver ui(two_walls());
  scroll(ui.queue, ui.find("materials"), 40);
  ui.move(ui.find("materials"));
  ui.click("projectile/count");
  ui.type("20000");
  EXPECT_EQ(ui.state.shot.count, 10000);
  EXPECT_THAT(ui.value("field_note"), ::testing::HasSubstr("Allowed: 1 to 10000"));
}

/// Every part of a body's and the scene's form is open, and all entries have fields.
Scene full_of_fields() {
  Scene scene = two_walls();
  scene.bodies[0].supports.resize(1);
  scene.bodies[0].loads.resize(1);
  scene.bodies[0].weakness = Weakness{};
  scene.bodies[0].strength_scatter = StrengthScatter{};
  scene.projectiles.resize(1);
  scene.probes = {probe_of("left", "tip")};
  scene.cameras.resize(1);
  return scene;
}

/// Tags of the number fields that are drawn: those with a value that a number can be read from.
std::vector<std::string> number_tags(UiDriver& ui) {
  std::vector<std::string> tags;
  for (const WidgetTag& tag : ui.tags) {
    const std::string part = tag.name.substr(0, tag.name.find('/'));
    const bool is_field = part == "body" || part == "entry" || part == "scene" || part == "material" ||
                          part == "projectile" || part == "toolbar";
    const bool is_number = !tag.value.empty() && tag.value.find_first_of("0123456789") <= 1;
    const bool is_label = tag.name == "toolbar/time" || tag.name == "toolbar/step" || tag.name == "toolbar/step_time";
    if (is_field && is_number && !is_label) tags.push_back(tag.name);
  }
  return tags;
}

TEST(NumberFields, NoClickOnAnyFieldOfAnyFormChangesAnything) {
  const Scene scene = full_of_fields();
  int fields = 0;
  for (const char* entry : {"bodies/0", "bodies/0/supports/0", "bodies/0/loads/0", "projectiles/0", "cameras/0"}) {
    UiDriver ui(scene);
    open_all_sections(ui);
    ui.click(entry);
    const ProjectileBurst shot = ui.state.shot;
    for (const std::string& tag : number_tags(ui)) {
      ++fields;
      const std::string shown = ui.value(tag);
      for (int clicks = 0; clicks < 2; ++clicks) ui.click(tag);
      EXPECT_EQ(ui.state.number.kind, NumberEdit::Kind::typed) << tag;
      ui.press_key(fields % 2 == 0 ? key::kEnter : key::kEscape);
      ui.frame();
      EXPECT_EQ(ui.value(tag), shown);
      EXPECT_EQ(ui.history.scene(), scene) << tag;
      EXPECT_EQ(ui.state.shot, shot) << tag;
    }
    EXPECT_TRUE(ui.history.entries().empty());
  }
  EXPECT_GT(fields, 80);
}

TEST(NumberFields, TheShownTextTypedBackChangesNothingButItsRounding) {
  UiDriver ui(full_of_fields());
  open_all_sections(ui);
  ui.history.change("odd numbers", [](Scene& scene) {
    scene.bodies[0].material.young_modulus = 12.34567891234e9;
    scene.bodies[0].position = Vec3(0.0123456789, 1e-4, 0);
  });
  ui.history.finish();
  ui.frame();
  for (const std::string& tag : number_tags(ui)) {
    const std::string shown = ui.value(tag);
    ui.click(tag);
    ui.type(shown + " ");
    ui.frame();
    EXPECT_EQ(ui.value(tag), shown) << tag;
    EXPECT_EQ(find_tag(ui.tags, "field_note"), nullptr) << tag;
  }
  EXPECT_NEAR(edited_material(ui).young_modulus, 12.34567891234e9, 1e-3 * 12e9);
}

TEST(NumberFields, ADragIsRelativeAndFine) {
  testing::RandomValues random(11);
  for (const auto& [low, high] : {std::pair(1.0, 1e13), std::pair(-1e6, 1e6), std::pair(0.0, 1e6)}) {
    for (int i = 0; i < 200; ++i) {
      const double value = std::pow(10, random.index(5)) * (1 + random.index(900) / 100.0);
      const DragStart start = {.value = value, .numbers = between(low, high, "m")};
      EXPECT_EQ(dragged_number(start, 0), value);
      double last = value;
      for (int moved = 1; moved < 60; ++moved) {
        const double now = dragged_number(start, moved), finer = dragged_number(start, 0.1 * moved, {.fine = true});
        EXPECT_GE(now, last) << value;
        EXPECT_LE(now - last, 0.0101 * last) << value << " at " << moved;
        EXPECT_LE(finer - value, 0.11 * (now - value) + 2e-3 * value);
        last = now;
      }
    }
  }
}

TEST(NumberFields, CtrlSnapsToRoundValues) {
  const DragStart modulus = {.value = 15.37e9, .numbers = between(1, 1e13, "Pa")};
  EXPECT_EQ(dragged_number(modulus, 10, {.coarse = true}), 16e9);
  const DragStart angle = {.value = 12.3, .numbers = between(-1e6, 1e6, "degrees")};
  EXPECT_EQ(dragged_number(angle, 10), 17.3);
  EXPECT_EQ(dragged_number(angle, 10, {.coarse = true}), 15);
  const DragStart ratio = {.value = 0.25, .numbers = between(0, 1, "-")};
  EXPECT_EQ(dragged_number(ratio, -1000), 0);
  EXPECT_EQ(dragged_number(ratio, 1000), 1);
  const DragStart count = {.value = 3, .numbers = between(1, 10000), .whole = true};
  EXPECT_EQ(dragged_number(count, 10), 4);
}

TEST(NumberFields, BareNumbersAreInTheUnitShownWhichStaysWhileTyping) {
  Scene scene = two_walls();
  scene.bodies[0].material.tensile_strength = 2e6;
  UiDriver ui(scene);
  ui.state.shot.radius = 0.2;
  ui.frame();
  EXPECT_EQ(ui.value("material/tensile_strength"), "2 MPa");
  ui.click("material/tensile_strength");
  ui.type("3");
  EXPECT_EQ(edited_material(ui).tensile_strength, 3e6);
  EXPECT_EQ(ui.value("projectile/radius"), "200 mm");
  ui.click("projectile/radius");
  for (const char letter : std::string("2*30+1 mm")) {
    ImGui::GetIO().AddInputCharacter(static_cast<unsigned char>(letter));
    ui.frame();
  }
  EXPECT_EQ(ui.value("typed_meaning"), "= 61 mm");
  ui.press_key('A', true);
  ui.type("1100");
  EXPECT_EQ(ui.state.shot.radius, 1.1);
}

TEST(NumberFields, TheUnitStaysWhileOneDrags) {
  Scene scene = two_walls();
  scene.bodies[0].position = Vec3(0.9, 0, 0);
  UiDriver ui(scene);
  open_all_sections(ui);
  const ImVec2 place = ui.find("body/position/0");
  ui.move(place);
  ui.press(0, true);
  ui.move({place.x + 100, place.y});
  EXPECT_GT(ui.history.scene().bodies[0].position.x(), 1.2);
  EXPECT_NE(find_tag(ui.tags, "label/Position [mm]"), nullptr);
  ui.press(0, false);
  ui.frame();
  EXPECT_NE(find_tag(ui.tags, "label/Position [m]"), nullptr);
  EXPECT_EQ(ui.history.entries().size(), 1u);
}

TEST(NumberFields, TheUnitOfARowStaysFromOneNumberToTheNext) {
  for (const bool by_tab : {true, false}) {
    Scene scene = two_walls();
    scene.bodies[0].position = Vec3(0.9, 0.1, 0);
    UiDriver ui(scene);
    open_all_sections(ui);
    ui.click("body/position/0");
    for (const char* text : {"1000", "710", "500"}) {
      type(ui.queue, text);
      if (by_tab) ui.press_key(key::kTab);
      if (!by_tab && text != std::string("500")) ui.click(text[0] == '1' ? "body/position/1" : "body/position/2");
      for (int i = 0; i < 3; ++i) ui.frame();
    }
    ui.press_key(key::kEnter);
    for (int i = 0; i < 8; ++i) ui.frame();
    EXPECT_EQ(ui.history.scene().bodies[0].position, Vec3(1, 0.71, 0.5)) << by_tab;
    EXPECT_NE(find_tag(ui.tags, "label/Position [m]"), nullptr);
  }
}

/// Both where the field that takes over is drawn before the one that was typed into, and behind it.
TEST(NumberFields, AClickOnAnotherFieldTakesWhatWasTyped) {
  UiDriver ui(two_walls());
  ui.click("material/density");
  type(ui.queue, "2000");
  ui.click("material/young_modulus");
  type(ui.queue, "20 GPa");
  ui.click("material/poisson_ratio");
  for (int i = 0; i < 3; ++i) ui.frame();
  EXPECT_EQ(edited_material(ui).density, 2000);
  EXPECT_EQ(edited_material(ui).young_modulus, 20e9);
}

TEST(NumberFields, EscapeTakesADragBack) {
  UiDriver ui(two_walls());
  const ImVec2 place = ui.find("material/density");
  ui.move(place);
  ui.press(0, true);
  ui.move({place.x + 50, place.y});
  EXPECT_NE(ui.history.scene(), two_walls());
  ui.press_key(key::kEscape);
  ui.move({place.x + 90, place.y});
  ui.press(0, false);
  EXPECT_EQ(ui.history.scene(), two_walls());
  EXPECT_TRUE(ui.history.entries().empty());
}

TEST(NumberFields, WorkThatAFieldBeganTakesNothingFromTheNextOne) {
  UiDriver ui(two_walls());
  ui.click("material/young_modulus");
  ui.press_key(key::kTab);
  ui.state.work = "Building bodies";
  for (int i = 0; i < 5; ++i) ui.frame();
  for (const char letter : std::string_view("0.31"))
    ImGui::GetIO().AddInputCharacter(static_cast<unsigned char>(letter));
  ui.frame();
  EXPECT_EQ(ui.value("material/poisson_ratio"), "0.31");
  EXPECT_EQ(ui.value("work/stage"), "no widget work/stage");
  EXPECT_EQ(ui.value("status/work"), "Building bodies ...");
  ui.press_key(key::kEnter);
  for (int i = 0; i < 3; ++i) ui.frame();
  EXPECT_EQ(edited_material(ui).poisson_ratio, 0.31);
  EXPECT_EQ(ui.value("work/stage"), "Building bodies") << "nothing is typed any more";
}

TEST(NumberFields, TabAndShiftTabGoFromFieldToFieldAndTakeWhatWasTyped) {
  UiDriver ui(two_walls());
  const auto type_and_tab = [&ui](const char* text, bool back) {
    type(ui.queue, text);
    ui.press_key(key::kTab, false, back);
    for (int i = 0; i < 3; ++i) ui.frame();
  };
  ui.click("material/young_modulus");
  type_and_tab("20 GPa", false);
  EXPECT_EQ(edited_material(ui).young_modulus, 20e9);
  EXPECT_EQ(ui.state.number.tag, "material/poisson_ratio");
  type_and_tab("0.3", false);
  EXPECT_EQ(ui.state.number.tag, "material/density");
  type_and_tab("2000", true);
  EXPECT_EQ(ui.state.number.tag, "material/poisson_ratio");
  type_and_tab("0.2", true);
  EXPECT_EQ(ui.state.number.tag, "material/young_modulus");
  EXPECT_EQ(edited_material(ui).poisson_ratio, 0.2);
  EXPECT_EQ(edited_material(ui).density, 2000);
}

TEST(NumberFields, ADoubleClickAtTenPicturesASecondOpensAndChoosesAll) {
  UiDriver ui(two_walls());
  ImGui::GetIO().DeltaTime = 0.1F;
  for (int clicks = 0; clicks < 2; ++clicks) click(ui.queue, ui.find("material/density"));
  ui.type("2500");
  EXPECT_EQ(edited_material(ui).density, 2500);
}

TEST(NumberFields, TheWheelChangesNoNumber) {
  UiDriver ui(two_walls());
  const ProjectileBurst shot = ui.state.shot;
  for (const std::string& tag : number_tags(ui)) {
    scroll(ui.queue, ui.find(tag), 3);
    ui.frame();
  }
  EXPECT_EQ(ui.history.scene(), two_walls());
  EXPECT_EQ(ui.state.shot, shot);
}

TEST(NumberFields, PositionAndTargetOfACameraShowOneUnit) {
  Scene scene = two_walls();
  scene.cameras.resize(1);
  scene.cameras[0].position = Vec3(0, 2, 5);
  scene.cameras[0].target = Vec3(0.01, 0.02, 0);
  UiDriver ui(scene);
  ui.click("cameras/0");
  EXPECT_NE(find_tag(ui.tags, "label/Position [m]"), nullptr);
  EXPECT_NE(find_tag(ui.tags, "label/Target [m]"), nullptr);
}

}  // namespace
}  // namespace griffith::ui
