#include "ui/model/plot_columns.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace griffith::ui {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

std::vector<double> counted(std::size_t count) {
  std::vector<double> times(count);
  for (std::size_t i = 0; i < count; ++i) times[i] = 0.01 * static_cast<double>(i);
  return times;
}

TEST(PlotColumns, KeepTheExtremesOfEveryColumnOfALongRun) {
  const std::vector<double> times = counted(100'000);
  std::vector<double> values(times.size());
  std::mt19937 random(5);
  for (double& value : values) value = std::uniform_real_distribution<double>(-1, 1)(random);
  values[54'321] = 1e6;  // single steps
  values[77'777] = -1e6;
  const PlotSpan span{times.front(), times.back(), 640};
  const std::vector<PlotColumn> columns = plot_columns(times, values, span);
  ASSERT_EQ(columns.size(), 640u);
  std::size_t step = 0;
  for (const PlotColumn& column : columns) {
    const std::size_t start = step;
    while (step < times.size() && span.column(times[step]) == column.column) ++step;
    ASSERT_GT(step, start);
    const auto [low, high] = std::minmax_element(values.begin() + static_cast<std::ptrdiff_t>(start),
                                                 values.begin() + static_cast<std::ptrdiff_t>(step));
    EXPECT_EQ(column.low, *low);
    EXPECT_EQ(column.high, *high);
    EXPECT_EQ(column.first, values[start]);
    EXPECT_EQ(column.last, values[step - 1]);
  }
  EXPECT_EQ(step, times.size()) << "every step is in a column";
}

TEST(PlotColumns, AreTheValuesThemselvesWhereThereAreFew) {
  const std::vector<double> times = counted(5), values = {3, 1, 4, 1, 5};
  const std::vector<PlotColumn> columns = plot_columns(times, values, {0, 0.04, 100});
  ASSERT_EQ(columns.size(), 5u);
  for (std::size_t i = 0; i < columns.size(); ++i) {
    EXPECT_EQ(columns[i].low, values[i]);
    EXPECT_EQ(columns[i].high, values[i]);
    EXPECT_EQ(columns[i].begins, i == 0);
  }
  EXPECT_EQ(columns.front().column, 0);
  EXPECT_EQ(columns.back().column, 99);
}

TEST(PlotColumns, BreakTheLineAtWhatCannotBeDrawn) {
  const std::vector<double> times = counted(6), values = {kNan, 1, 2, INFINITY, 3, 0};
  const PlotSpan span{0, 0.05, 50};
  const std::vector<PlotColumn> columns = plot_columns(times, values, span);
  ASSERT_EQ(columns.size(), 4u);
  EXPECT_TRUE(columns[0].begins);
  EXPECT_FALSE(columns[1].begins);
  EXPECT_TRUE(columns[2].begins);
  EXPECT_EQ(plot_columns(times, values, span, 0).size(), 3u) << "0 has no logarithm";
}

TEST(PlotColumns, TakeWhatHasNoLength) {
  const std::vector<double> nothing, same = {1, 1, 1}, values = {2, 7, 3};
  EXPECT_TRUE(plot_columns(nothing, nothing, {0, 1, 10}).empty());
  const std::vector<PlotColumn> one = plot_columns(same, values, {1, 1, 10});
  ASSERT_EQ(one.size(), 1u);
  EXPECT_EQ(one[0].high, 7);
  EXPECT_EQ(plot_columns(same, values, {0, 2, 0}).size(), 1u) << "a window without width";
}

}  // namespace
}  // namespace griffith::ui
