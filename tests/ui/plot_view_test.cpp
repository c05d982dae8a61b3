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

TEST(PlotChoice, ASeriesThatGoesLeavesTheColorsOfOthers) {
  PlotChoice chosen;
  std::vector<RunSeries> there;
  for (const char* key : {"a", "b", "c", "d", "e", "f", "g"}) there.push_back({key, "", "", ""});
  for (const RunSeries& series : there) toggle_series(chosen, series.key, there);
  EXPECT_THAT(chosen, ::testing::ElementsAre("a", "b", "c", "d", "e", "f")) << "there is no seventh";
  toggle_series(chosen, "b", there);
  EXPECT_EQ(count_series(chosen, there), 5u);
  EXPECT_EQ(chosen[2], "c");
  toggle_series(chosen, "g", there);
  EXPECT_EQ(chosen[1], "g");
  there.erase(there.begin() + 3);  // "d", as in a scene that lacks a probe
  EXPECT_EQ(count_series(chosen, there), 5u);
  toggle_series(chosen, "b", there);
  EXPECT_EQ(chosen[3], "b") << "what is not there keeps no place";
}

TEST(PlotRange, DecadesHoldAllPositiveValues) {
  const auto decades = [](std::vector<double> values) {
    const RunCurve curve = curve_of("J", std::move(values));
    const RunCurve* const curves[] = {&curve};
    const PlotRange range = decade_range(curves);
    return std::pair(std::log10(range.low), std::log10(range.high));
  };
  EXPECT_EQ(decades({0, 3, 20, 4000, NAN, -7}), std::pair(0.0, 4.0));
  EXPECT_EQ(decades({100}), std::pair(1.0, 2.0)) << "never empty";
  EXPECT_EQ(decades({0, -1}), std::pair(0.0, 1.0));
  EXPECT_EQ(decades({1e-30, 1e3}), std::pair(-9.0, 3.0)) << "twelve at most";
  EXPECT_THAT(decade_ticks({1, 1e4}, 10), ::testing::ElementsAre(1, 10, 100, 1000, 10000));
  EXPECT_THAT(decade_ticks({1, 1e4}, 2), ::testing::ElementsAre(1, 100, 10000));
}

TEST(PlotView, EqualDistancesAreEqualRatiosOnALogarithmicScale) {
  const PlotView view{.top = 100, .bottom = 400, .range = {1, 1000}, .logarithmic = true};
  EXPECT_NEAR(view.y(1), 400, 1e-9);
  EXPECT_NEAR(view.y(10), 300, 1e-9);
  EXPECT_NEAR(view.y(100), 200, 1e-9);
  EXPECT_EQ(view.y(0), 400);
  EXPECT_EQ(view.y(-5), 400);
  EXPECT_EQ(view.floor(), 0) << "what is not positive is not drawn";
}

TEST(PlotZoom, TheStepUnderTheMouseStaysWhereItIs) {
  const StepSpan whole{0, 1000};
  StepSpan shown = whole;
  for (int i = 0; i < 60; ++i) {
    const StepSpan next = zoomed(shown, whole, 300, 0.8);
    const double before = static_cast<double>(300 - shown.first) / static_cast<double>(shown.last - shown.first);
    const double after = static_cast<double>(300 - next.first) / static_cast<double>(next.last - next.first);
    EXPECT_NEAR(before, after, 1.0 / static_cast<double>(next.last - next.first));
    EXPECT_LE(next.last - next.first, shown.last - shown.first);
    shown = next;
  }
  EXPECT_EQ(shown.last - shown.first, 4) << "some are left";
  for (int i = 0; i < 60; ++i) shown = zoomed(shown, whole, 300, 1.25);
  EXPECT_EQ(shown, whole);
}

TEST(PlotZoom, StaysWithinWhatWasRecorded) {
  const StepSpan whole{10, 110};
  EXPECT_EQ(moved({20, 40}, whole, 30), (StepSpan{50, 70}));
  EXPECT_EQ(moved({20, 40}, whole, -30), (StepSpan{10, 30}));
  EXPECT_EQ(moved({20, 40}, whole, 300), (StepSpan{90, 110}));
  EXPECT_EQ(moved({20, 400}, whole, 0), whole);
  EXPECT_EQ(zoomed(whole, whole, 110, 0.5), (StepSpan{60, 110}));
  EXPECT_EQ(zoomed({10, 10}, {10, 10}, 10, 0.8), (StepSpan{10, 10})) << "nothing recorded yet";
}

TEST(PlotZoom, APartHasTheStepsBetween) {
  const RunCurves curves{{0, 1, 2, 3, 4}, {0, 0.1, 0.2, 0.3, 0.4}, {curve_of("J", {5, 6, 7, 8, 9})}};
  const RunCurves part = part_of(curves, {1, 3});
  EXPECT_THAT(part.steps, ::testing::ElementsAre(1, 2, 3));
  EXPECT_THAT(part.times, ::testing::ElementsAre(0.1, 0.2, 0.3));
  EXPECT_THAT(part.curves[0].values, ::testing::ElementsAre(6, 7, 8));
  EXPECT_TRUE(part_of(curves, {7, 9}).steps.empty());
}

}  // namespace
}  // namespace griffith::ui
