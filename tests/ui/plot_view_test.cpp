#include "ui/model/plot_view.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace griffith::ui {
namespace {

RunCurve curve_of(const std::string& unit, std::vector<double> values) { return {{"a", "", "A", unit}, 0, values}; }

PlotRange range_for(std::vector<double> values) {
  const RunCurve curve = curve_of("J", std::move(values));
  const RunCurve* const curves[] = {&curve};
  return plot_range(curves);
}

TEST(PlotView, AStepIsFoundAgainWhereItIsDrawn) {
  for (const std::int64_t last : {4, 5, 40, 300, 613}) {
    const PlotView view{.left = 120, .right = 733, .first_step = 3, .last_step = last, .time_step = 0.01, .range = {}};
    for (std::int64_t step = 3; step <= last; ++step) EXPECT_EQ(view.step_at(view.x(step)), step);
    EXPECT_EQ(view.x(3), 120);
    EXPECT_EQ(view.x(last), 733);
    EXPECT_EQ(view.step_at(-1e9), 3);
    EXPECT_EQ(view.step_at(1e9), last);
  }
}

TEST(PlotView, AColumnOfTheCurveIsWhereItsStepIs) {
  const PlotView view{.left = 50, .right = 450, .first_step = 10, .last_step = 210, .time_step = 0.02, .range = {}};
  for (std::int64_t step = 10; step <= 210; ++step)
    EXPECT_NEAR(view.left + view.span().column(static_cast<double>(step) * view.time_step), view.x(step), 1.001);
}

TEST(PlotView, ValuesGrowUpwardsAndStayWithin) {
  const PlotView view{.top = 100, .bottom = 300, .range = {-2, 8}};
  EXPECT_EQ(view.y(-2), 300);
  EXPECT_EQ(view.y(3), 200);
  EXPECT_EQ(view.y(8), 100);
  EXPECT_EQ(view.y(1e30), 100);
}

TEST(PlotView, TakesWhatHasNoLength) {
  const PlotView view{.left = 10, .right = 10, .first_step = 7, .last_step = 7, .time_step = 0.01, .range = {}};
  EXPECT_EQ(view.step_at(500), 7);
  EXPECT_EQ(view.x(7), 10);
  EXPECT_EQ(view.span().columns, 1);
}

TEST(PlotRange, HoldsAllValuesAndIsNeverEmpty) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const std::vector<std::vector<double>> cases = {
      {}, {0, 0}, {5}, {-5, -5}, {1, 2, 3}, {-1, 1}, {1e-300, 2e-300}, {1000, 1000.001}, {kInfinity, 4, NAN}};
  for (const std::vector<double>& values : cases) {
    const PlotRange range = range_for(values);
    EXPECT_LT(range.low, range.high);
    for (const double value : values)
      EXPECT_TRUE(!std::isfinite(value) || (range.low <= value && value <= range.high)) << value;
  }
}

TEST(PlotRange, BeginsAtZeroUnlessThatIsFar) {
  EXPECT_EQ(range_for({1, 10}).low, 0);
  EXPECT_EQ(range_for({-10, -1}).high, 0);
  EXPECT_GT(range_for({1000, 1001}).low, 999);
}

TEST(PlotStrips, CurvesOfAUnitShareOne) {
  RunCurves curves;
  for (const char* unit : {"J", "", "J", "-", ""}) curves.curves.push_back(curve_of(unit, {}));
  const std::vector<PlotStrip> strips = plot_strips(curves);
  ASSERT_EQ(strips.size(), 3u);
  EXPECT_THAT(strips[0].curves, ::testing::ElementsAre(&curves.curves[0], &curves.curves[2]));
  EXPECT_THAT(strips[1].curves, ::testing::ElementsAre(&curves.curves[1], &curves.curves[4]));
  EXPECT_EQ(strips[2].unit, "-");
}

TEST(PlotChoice, ASeriesThatGoesLeavesTheColoursOfOthers) {
  PlotChoice chosen;
  for (const char* key : {"a", "b", "c", "d", "e", "f", "g"}) toggle_series(chosen, key);
  EXPECT_THAT(chosen, ::testing::ElementsAre("a", "b", "c", "d", "e", "f")) << "there is no seventh";
  toggle_series(chosen, "b");
  EXPECT_EQ(count_series(chosen), 5u);
  EXPECT_EQ(chosen[2], "c");
  toggle_series(chosen, "g");
  EXPECT_EQ(chosen[1], "g");
}

}  // namespace
}  // namespace griffith::ui
