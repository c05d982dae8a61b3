// What is typed into numbers, and what they say of it.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "ui/widgets/field_range.h"
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
  EXPECT_EQ(meaning_of("0.1"), "= 100 mm");
  EXPECT_EQ(meaning_of("12 mm"), "= 12 mm");
  EXPECT_EQ(meaning_of("3e5"), "= 10 km: 100 µm to 10 km is possible.");
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
