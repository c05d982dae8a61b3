#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "ui_driver.h"

namespace griffith::ui {
namespace {

class LogPanelTest : public ::testing::Test {
 protected:
  LogPanelTest() {
    ui_.state.log = {
        {LogLevel::info, "Opened a wall"}, {LogLevel::warning, "The wall is thin"}, {LogLevel::error, "No such file"}};
    ui_.state.log_view.shown = true;
    for (int i = 0; i < 3; ++i) ui_.frame();
  }

  std::vector<std::string> lines() const {
    std::vector<std::string> lines;
    for (const WidgetTag& tag : ui_.tags)
      if (tag.name == "log/line") lines.push_back(tag.value);
    return lines;
  }

  UiDriver ui_{two_walls()};
};

TEST_F(LogPanelTest, ShowsLevelsThatAreOnAndLinesWithTheText) {
  EXPECT_THAT(lines(), ::testing::ElementsAre("Opened a wall", "The wall is thin", "No such file"));
  ui_.click("log/info");
  EXPECT_THAT(lines(), ::testing::ElementsAre("The wall is thin", "No such file"));
  ui_.click("log/info");
  ui_.click("log/filter");
  ui_.type("wall");
  EXPECT_THAT(lines(), ::testing::ElementsAre("Opened a wall", "The wall is thin"));
}

TEST_F(LogPanelTest, CopiesWhatIsShown) {
  ui_.click("log/errors");
  ui_.click("log/copy");
  EXPECT_STREQ(ImGui::GetClipboardText(), "Opened a wall\nThe wall is thin\n");
}

TEST_F(LogPanelTest, ClearsAndClosesAndTheViewGetsItsRoomBack) {
  const float with_log = ui_.state.viewport_size.y;
  ui_.click("log/clear");
  EXPECT_TRUE(lines().empty());
  EXPECT_EQ(find_tag(ui_.tags, "status/message"), nullptr);
  ui_.click("log/close");
  ui_.frame();
  EXPECT_FALSE(ui_.state.log_view.shown);
  EXPECT_GT(ui_.state.viewport_size.y, with_log + 90);
}

TEST_F(LogPanelTest, DoesNotCoverTheView) {
  const WidgetTag* view = find_tag(ui_.tags, "viewport");
  const WidgetTag* filter = find_tag(ui_.tags, "log/filter");
  EXPECT_LE(view->maximum.y, filter->minimum.y);
  EXPECT_LE(filter->maximum.y, find_tag(ui_.tags, "time/bar")->minimum.y);
}

}  // namespace
}  // namespace griffith::ui
