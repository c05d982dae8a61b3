// Sections of the side panels: order, folding, hiding, and the usual layout.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/random_values.h"
#include "ui/model/section_order.h"
#include "ui_driver.h"

namespace griffith::ui {
namespace {

TEST(SectionOrder, MovesKeepEachSectionOnce) {
  testing::RandomValues random(8);
  SectionOrder order;
  std::vector<std::string> names = order.left;
  names.insert(names.end(), order.right.begin(), order.right.end());
  for (int trial = 0; trial < 500; ++trial) {
    const std::string name = names[static_cast<std::size_t>(random.index(static_cast<int>(names.size())))];
    const std::string before = names[static_cast<std::size_t>(random.index(static_cast<int>(names.size())))];
    const bool left = random.index(2) == 0;
    move_section(order, name, left, before);
    ASSERT_TRUE(is_complete(order));
    const std::vector<std::string>& side = order.side(left);
    const auto at = std::ranges::find(side, name), next = std::ranges::find(side, before);
    if (name != before && next != side.end()) {
      EXPECT_EQ(next - at, 1);
    }
  }
}

TEST(SectionOrder, MissingDoubledAndUnknownSectionsAreIncomplete) {
  SectionOrder order;
  order.right.pop_back();
  EXPECT_FALSE(is_complete(order));
  order.right.push_back("view");
  EXPECT_FALSE(is_complete(order));
  order.right.back() = "statistics";
  EXPECT_TRUE(is_complete(order));
  order.folded = {"nothing"};
  EXPECT_FALSE(is_complete(order));
}

TEST(SidePanels, GripsMoveSectionsToTheOtherSide) {
  UiDriver ui(two_walls());
  const float across = ui.find("section/statistics").x - ui.find("section/projectile").x;
  ui.drag("section/statistics", -across, ui.find("section/projectile").y - ui.find("section/statistics").y);
  const SectionOrder& order = ui.state.preferences.sections;
  EXPECT_EQ(std::ranges::count(order.left, "statistics"), 1);
  EXPECT_EQ(std::ranges::count(order.right, "statistics"), 0);
  ui.frame();
  EXPECT_LT(ui.find("section/statistics").x, ui.state.left_width);
  EXPECT_TRUE(ui.history.entries().empty());
}

TEST(SidePanels, AClickOnAGripFoldsAndUnfolds) {
  UiDriver ui(two_walls());
  ASSERT_TRUE(find_tag(ui.tags, "view/quantity"));
  ui.click("section/view");
  EXPECT_FALSE(find_tag(ui.tags, "view/quantity"));
  EXPECT_EQ(ui.value("section/view"), "folded");
  ui.click("section/view");
  EXPECT_TRUE(find_tag(ui.tags, "view/quantity"));
}

TEST(SidePanels, AreHiddenAndTheViewGetsTheirRoom) {
  UiDriver ui(two_walls());
  const float width = ui.state.viewport_size.x;
  ui.state.preferences.show_left = ui.state.preferences.show_right = false;
  ui.frame();
  ui.frame();
  EXPECT_EQ(ui.state.viewport_size.x, 1500);
  EXPECT_FALSE(find_tag(ui.tags, "section/view"));
  ui.state.preferences.show_left = ui.state.preferences.show_right = true;
  ui.frame();
  ui.frame();
  EXPECT_EQ(ui.state.viewport_size.x, width);
}

TEST(SidePanels, HeightsOfDocksAreKept) {
  UiDriver ui(two_walls());
  ui.state.log_view.shown = true;
  ui.frame();
  EXPECT_EQ(ui.state.preferences.log_height, 0) << "automatic until it is dragged";
  ui.state.preferences.log_height = 222;
  ui.state.log_view.height = 0;
  ui.frame();
  ui.frame();
  EXPECT_EQ(ui.state.log_view.height, 222);
}

TEST(SidePanels, ResetRestoresTheUsualLayout) {
  UiDriver ui(two_walls());
  const float width = ui.state.viewport_size.x;
  Preferences& mine = ui.state.preferences;
  mine.show_left = false;
  mine.log_height = 400;
  mine.right_width = 500;
  mine.mouse_speed = 2;
  move_section(mine.sections, "view", true, "");
  mine.sections.folded = {"outliner"};
  ui.state.four_views.shown = true;
  ui.state.right_width = 0;
  ui.frame();
  reset_layout(ui.state);
  ui.frame();
  ui.frame();
  Preferences expected;
  expected.mouse_speed = 2;
  EXPECT_EQ(mine, expected) << "other preferences stay";
  EXPECT_FALSE(ui.state.four_views.shown);
  EXPECT_EQ(ui.state.viewport_size.x, width);
}

}  // namespace
}  // namespace griffith::ui
