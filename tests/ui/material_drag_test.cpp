// Materials dragged from their list onto bodies, in the view and in the outliner.

#include <gtest/gtest.h>

#include <array>

#include "sim/world/world.h"
#include "ui/model/entry_choice.h"
#include "ui/model/material_choice.h"
#include "ui_driver.h"

namespace griffith::ui {
namespace {

class MaterialDrag : public ::testing::Test {
 protected:
  MaterialDrag() {
    ui_.input.frame = world_.frame();
    ui_.frame();
    ui_.click("materials");
    ui_.frame();
  }
  const std::string& material(std::size_t body) const { return ui_.history.scene().bodies[body].material.name; }
  /// Presses on a material and moves over a place, where `body` is.
  void carry(const std::string& tag, ImVec2 place, int body) {
    ui_.move(ui_.find(tag));
    ui_.press(0, true);
    for (const float part : {0.3f, 0.6f, 1.0f}) {
      const ImVec2 start = ui_.find(tag);
      ui_.move({start.x + part * (place.x - start.x), start.y + part * (place.y - start.y)});
    }
    ui_.input.pointed = BodyId(body);
    ui_.frame();
    ui_.frame();
  }

  World world_{two_walls()};
  UiDriver ui_{two_walls()};
};

TEST_F(MaterialDrag, OntoABodyInTheView) {
  carry("materials/granite", ui_.find("viewport"), 1);
  EXPECT_EQ(ui_.value("materials/dragged"), "granite onto right");
  ui_.press(0, false);
  EXPECT_NE(material(0), "granite");
  EXPECT_EQ(material(1), "granite");
  ASSERT_EQ(ui_.history.entries().size(), 1u);
  EXPECT_EQ(ui_.history.entries()[0].label, "Set material granite");
  ui_.frame();
  EXPECT_FALSE(ui_.state.dragged_material);
  ui_.history.undo();
  EXPECT_EQ(ui_.history.scene(), two_walls());
}

TEST_F(MaterialDrag, OntoNothingInTheView) {
  carry("materials/granite", ui_.find("viewport"), -1);
  ui_.press(0, false);
  EXPECT_EQ(ui_.history.scene(), two_walls());
  EXPECT_TRUE(ui_.history.entries().empty());
}

TEST_F(MaterialDrag, OntoOneOfSeveralSelectedBodies) {
  select_entries(ui_.state, ui_.history.scene(), {{EntryKind::body, 1}, {EntryKind::body, 0}});
  ui_.frame();
  carry("materials/granite", ui_.find("viewport"), 1);
  EXPECT_EQ(ui_.value("materials/dragged"), "granite onto left and 1 more");
  ui_.press(0, false);
  EXPECT_EQ(material(0), "granite");
  EXPECT_EQ(material(1), "granite");
  EXPECT_EQ(ui_.history.entries().size(), 1u);
}

TEST_F(MaterialDrag, OntoARowOfTheOutliner) {
  carry("materials/granite", ui_.find("bodies/1"), -1);
  ui_.press(0, false);
  ui_.frame();
  EXPECT_EQ(material(1), "granite");
  EXPECT_NE(material(0), "granite");
}

TEST_F(MaterialDrag, AClickGivesItToTheSelectedBodies) {
  ui_.click("materials/granite");
  EXPECT_EQ(material(0), "granite");
  EXPECT_NE(material(1), "granite");
}

TEST(OfferedMaterials, AreTheScenesOwnThenThePresets) {
  Scene scene = two_walls();
  Material own = *find_material_preset("granite");
  own.young_modulus *= 2;
  scene.materials = {own};
  const std::vector<Material> offered = offered_materials(scene);
  EXPECT_EQ(offered.front(), own);
  EXPECT_EQ(offered.size(), material_presets().size()) << "the preset of that name is hidden";
}

}  // namespace
}  // namespace griffith::ui
