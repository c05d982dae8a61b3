#include "ui/model/scene_browser.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "ui_driver.h"

namespace griffith::ui {
namespace {

using ::testing::ElementsAre;

/// Five scenes of two topics, which come by turns.
std::vector<SceneCard> five_scenes() {
  return {{"a/arch.json", "Arch", "Stacks", "Nine stones"},
          {"a/bar.json", "Bar", "Statics", "Pulled at both ends"},
          {"a/column.json", "Column", "Stacks", "Six drums, struck"},
          {"a/disc.json", "Disc", "Statics", "Pressed together"},
          {"a/tower.json", "Tower", "Stacks", "Ten blocks"}};
}

std::vector<std::string> titles(const std::vector<const SceneCard*>& cards) {
  std::vector<std::string> result;
  for (const SceneCard* card : cards) result.push_back(card->title);
  return result;
}

TEST(SceneBrowser, CardsOfATopicStandTogether) {
  const std::vector<SceneCard> cards = five_scenes();
  EXPECT_THAT(titles(shown_cards(cards, "")), ElementsAre("Arch", "Column", "Tower", "Bar", "Disc"));
}

TEST(SceneBrowser, EveryWordIsLookedForInNameTopicAndDescription) {
  const std::vector<SceneCard> cards = five_scenes();
  EXPECT_THAT(titles(shown_cards(cards, "STACKS six")), ElementsAre("Column"));
  EXPECT_THAT(titles(shown_cards(cards, "disc.json")), ElementsAre("Disc"));
  EXPECT_THAT(titles(shown_cards(cards, "pulled stacks")), ElementsAre());
}

TEST(SceneBrowser, RowsAreFullButForTheLast) {
  EXPECT_THAT(card_rows(5, 2), ElementsAre(CardRow{0, 2}, CardRow{2, 2}, CardRow{4, 1}));
  EXPECT_TRUE(card_rows(0, 2).empty());
}

TEST(SceneBrowser, ArrowsGoToTheCardThatIsSeenThere) {
  const std::vector<CardRow> rows = card_rows(5, 2);
  EXPECT_EQ(moved_choice(rows, 0, 1, 0), 1u);
  EXPECT_EQ(moved_choice(rows, 1, 1, 0), 2u) << "on to the next row";
  EXPECT_EQ(moved_choice(rows, 0, -1, 0), 0u);
  EXPECT_EQ(moved_choice(rows, 4, 1, 0), 4u);
  EXPECT_EQ(moved_choice(rows, 1, 0, 1), 3u);
  EXPECT_EQ(moved_choice(rows, 3, 0, 1), 4u) << "nothing lies below it but the last";
  EXPECT_EQ(moved_choice(rows, 4, 0, 1), 4u);
  EXPECT_EQ(moved_choice(rows, 3, 0, -2), 1u);
  EXPECT_EQ(moved_choice({}, 3, 1, 1), 0u);
}

/// The dialog over five scenes.
class ScenesDialog : public ::testing::Test {
 protected:
  ScenesDialog() : ui_(two_walls()), cards_(five_scenes()) {
    ui_.input.scene_cards = cards_;
    ui_.state.browser.shown = true;
    for (int i = 0; i < 4; ++i) ui_.frame();
  }

  std::filesystem::path opened() const { return ui_.commands.empty() ? "nothing" : ui_.commands.back().path; }

  UiDriver ui_;
  std::vector<SceneCard> cards_;
};

TEST_F(ScenesDialog, AClickOpensTheScene) {
  ui_.click("scenes/disc");
  EXPECT_THAT(ui_.issued(), ElementsAre("file.open_path"));
  EXPECT_EQ(opened(), "a/disc.json");
  EXPECT_FALSE(ui_.state.browser.shown);
}

TEST_F(ScenesDialog, ArrowsChooseAndEnterOpens) {
  EXPECT_EQ(ui_.value("scenes/about"), "Nine stones");
  for (int i = 0; i < 3; ++i) ui_.press_key(key::kRight);
  EXPECT_EQ(ui_.value("scenes/about"), "Pulled at both ends") << "of the other topic";
  ui_.press_key(key::kRight);
  ui_.press_key(key::kEnter);
  EXPECT_EQ(opened(), "a/disc.json");
}

TEST_F(ScenesDialog, WhatIsTypedNarrowsTheListDown) {
  ui_.type("drums");
  EXPECT_EQ(opened(), "a/column.json");
}

TEST_F(ScenesDialog, NothingFoundOpensNothing) {
  ui_.type("no such scene");
  EXPECT_TRUE(ui_.commands.empty());
  EXPECT_EQ(ui_.value("scenes/about"), "No scene matches.");
  ui_.press_key(key::kEscape);
  EXPECT_FALSE(ui_.state.browser.shown);
}

TEST_F(ScenesDialog, AnotherFileIsAskedForInTheOpenDialog) {
  ui_.click("scenes/other");
  EXPECT_TRUE(ui_.state.show_open && !ui_.state.browser.shown);
  ui_.frame();
  ui_.frame();
  ui_.click("open/scenes");
  EXPECT_THAT(ui_.issued(), ElementsAre("file.scenes"));
}

TEST_F(ScenesDialog, TopicsStandOverTheirCardsSideBySide) {
  const WidgetTag *stacks = find_tag(ui_.tags, "scenes/topic/Stacks"),
                  *statics = find_tag(ui_.tags, "scenes/topic/Statics");
  ASSERT_TRUE(stacks && statics);
  EXPECT_EQ(stacks->minimum.y, statics->minimum.y) << "there is room for all in a row";
  EXPECT_EQ(stacks->minimum.x, find_tag(ui_.tags, "scenes/arch")->minimum.x);
  EXPECT_EQ(statics->minimum.x, find_tag(ui_.tags, "scenes/bar")->minimum.x);
}

}  // namespace
}  // namespace griffith::ui
