#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "ui/model/plot_view.h"
#include "ui_driver.h"

namespace griffith::ui {
namespace {

using ::testing::ElementsAre;

/// Plots of ten steps, of which the fourth is shown.
class PlotPanelTest : public ::testing::Test {
 protected:
  PlotPanelTest() {
    ui_.input.time.last_step = 10;
    ui_.input.time.time_step = 0.5;
    ui_.input.frame.step = 4;
    ui_.input.series = kSeries;
    ui_.state.plots.shown = true;
    ui_.state.preferences.plotted = {"energy", "pieces"};
    for (int i = 0; i <= 10; ++i) {
      ui_.input.curves.steps.push_back(i);
      ui_.input.curves.times.push_back(0.5 * i);
    }
    ui_.input.curves.curves = {{kSeries[0], 0, {0, 1e3, 2e3, 3e3, 4e3, 5e3, 6e3, 7e3, 8e3, 9e3, 1e4}},
                               {kSeries[1], 1, {1, 1, 1, 1, 1, 1, 2, 5, 5, 5, 5}}};
    for (int i = 0; i < 3; ++i) ui_.frame();
  }

  const WidgetTag& tag(const std::string& name) const { return *find_tag(ui_.tags, name); }
  std::vector<std::int64_t> steps_gone_to() const {
    std::vector<std::int64_t> steps;
    for (const Command& command : ui_.commands)
      if (command.name == "time.step") steps.push_back(command.step);
    return steps;
  }

  inline static const std::vector<RunSeries> kSeries = {
      {"energy", "Energy", "Kinetic", "J"}, {"pieces", "Step", "Pieces", ""}, {"cracks", "Step", "Cracks", ""}};
  UiDriver ui_{two_walls()};
};

TEST_F(PlotPanelTest, HasAStripForEachUnitBelowTheView) {
  EXPECT_EQ(ui_.value("plots/strip/0"), "Kinetic [kJ]");
  EXPECT_EQ(ui_.value("plots/strip/1"), "Pieces");
  EXPECT_LE(tag("viewport").maximum.y, tag("plots/series").minimum.y);
  EXPECT_LE(tag("plots/strip/0").maximum.y, tag("plots/strip/1").minimum.y);
  EXPECT_LE(tag("plots/strip/1").maximum.y, tag("time/bar").minimum.y);
}

TEST_F(PlotPanelTest, AClickGoesToTheStepUnderTheMouse) {
  const WidgetTag strip = tag("plots/strip/0");
  ui_.move({strip.maximum.x - 6, strip.center().y});
  EXPECT_EQ(ui_.value("plots/step"), "10");
  EXPECT_EQ(ui_.value("plots/value/energy"), "10 kJ");
  EXPECT_EQ(ui_.value("plots/value/pieces"), "5") << "curves of all strips have values";
  EXPECT_TRUE(steps_gone_to().empty()) << "nothing is pressed";
  ui_.press(0, true);
  ui_.press(0, false);
  ASSERT_FALSE(steps_gone_to().empty());
  EXPECT_EQ(steps_gone_to().back(), 10);
}

TEST_F(PlotPanelTest, ADragPassesTheStepsBetween) {
  const WidgetTag strip = tag("plots/strip/1");
  ui_.drag("plots/strip/1", strip.minimum.x - strip.center().x);
  const std::vector<std::int64_t> steps = steps_gone_to();
  ASSERT_GT(steps.size(), 3u);
  EXPECT_TRUE(std::ranges::is_sorted(steps, std::greater<>()));
  EXPECT_EQ(steps.back(), 0);
}

TEST_F(PlotPanelTest, AStepThatWasForgottenIsSaidToBe) {
  RunCurves& curves = ui_.input.curves;
  curves.steps.erase(curves.steps.begin(), curves.steps.begin() + 6);
  curves.times.erase(curves.times.begin(), curves.times.begin() + 6);
  for (RunCurve& curve : curves.curves) curve.values.erase(curve.values.begin(), curve.values.begin() + 6);
  const WidgetTag strip = tag("plots/strip/0");
  ui_.move({strip.center().x - 100, strip.center().y});
  EXPECT_LT(std::stoi(ui_.value("plots/step")), 6);
  EXPECT_FALSE(find_tag(ui_.tags, "plots/value/energy"));
}

TEST_F(PlotPanelTest, TheListChoosesSeries) {
  ui_.click("plots/series");
  EXPECT_EQ(ui_.value("plots/series/pieces"), "on");
  ui_.click("plots/series/pieces");
  ui_.click("plots/series/cracks");
  EXPECT_THAT(ui_.state.preferences.plotted, ElementsAre("energy", "cracks", "", "", "", ""));
  EXPECT_EQ(ui_.value("plots/series"), "2 of 6 series");
}

TEST_F(PlotPanelTest, ButtonsSaveAndClose) {
  ui_.click("plots/save");
  ui_.click("plots/close");
  EXPECT_THAT(ui_.issued(), ElementsAre("file.plots", "view.plots"));
  ui_.state.preferences.plotted = {};
  ui_.input.curves = {};
  ui_.frame();
  EXPECT_FALSE(find_tag(ui_.tags, "plots/strip/0"));
  ui_.click("plots/save");
  EXPECT_EQ(ui_.issued().size(), 2u) << "nothing is plotted";
}

TEST_F(PlotPanelTest, LogAndPlotsAndViewHaveRoomBesideEachOther) {
  ui_.state.log_view.shown = true;
  for (int i = 0; i < 3; ++i) ui_.frame();
  EXPECT_LE(tag("viewport").maximum.y, tag("log/filter").minimum.y);
  EXPECT_LE(tag("log/filter").maximum.y, tag("plots/series").minimum.y);
  EXPECT_GT(tag("viewport").maximum.y - tag("viewport").minimum.y, 150);
}

TEST_F(PlotPanelTest, SixUnitsKeepAReadableHeightAndScroll) {
  std::vector<RunCurve>& curves = ui_.input.curves.curves;
  curves.resize(1);
  for (std::size_t slot = 1; slot < kMaxPlotted; ++slot) {
    curves.push_back(curves[0]);
    curves.back().slot = slot;
    curves.back().series.unit = "unit " + std::to_string(slot);
  }
  for (int i = 0; i < 3; ++i) ui_.frame();
  EXPECT_GE(tag("plots/strip/5").maximum.y - tag("plots/strip/5").minimum.y, 50);
}

TEST_F(PlotPanelTest, TheWheelShowsFewerStepsAndAllBringsThemBack) {
  ui_.input.time.last_step = 100;
  for (int i = 0; i < 3; ++i) ui_.frame();
  const WidgetTag strip = tag("plots/strip/0");
  scroll(ui_.queue, {strip.maximum.x - 8, strip.center().y}, -4);
  ui_.move({strip.maximum.x - 8, strip.center().y + 1});
  ASSERT_TRUE(ui_.state.plots.zoom);
  EXPECT_EQ(ui_.state.plots.zoom->last, 100) << "the step under the mouse stays";
  EXPECT_EQ(ui_.state.plots.zoom->first, 59) << "as many times .8 as notches";
  ui_.move({strip.minimum.x + 66, strip.center().y});
  EXPECT_GE(std::stoi(ui_.value("plots/step")), 59);
  ui_.queue.key(key::kLeftShift, true);
  scroll(ui_.queue, strip.center(), -2);
  ui_.queue.key(key::kLeftShift, false);
  ui_.move(strip.center());
  EXPECT_EQ(*ui_.state.plots.zoom, (StepSpan{51, 92})) << "with Shift earlier ones";
  ui_.click("plots/whole");
  EXPECT_FALSE(ui_.state.plots.zoom);
  EXPECT_TRUE(steps_gone_to().empty());
}

TEST_F(PlotPanelTest, TheLogarithmIsKeptAsAPreference) {
  ui_.click("plots/logarithmic");
  EXPECT_TRUE(ui_.state.preferences.logarithmic_plots);
  EXPECT_EQ(ui_.value("plots/strip/0"), "Kinetic [J]") << "decades have prefixes of their own";
  ui_.click("plots/logarithmic");
  EXPECT_EQ(ui_.value("plots/strip/0"), "Kinetic [kJ]");
}

}  // namespace
}  // namespace griffith::ui
