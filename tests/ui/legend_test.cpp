#include "ui/widgets/legend.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace griffith::ui {
namespace {

TEST(Legend, TicksAreRoundEvenlySpacedAndInside) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> mantissa(-1, 1), exponent(-9, 9);
  for (int i = 0; i < 5000; ++i) {
    const double scale = std::pow(10, exponent(random));
    const double a = scale * mantissa(random), b = scale * mantissa(random);
    if (std::abs(a - b) < 1e-3 * scale) continue;
    const double low = std::min(a, b), high = std::max(a, b), slack = 1e-6 * (high - low);
    const std::vector<double> ticks = legend_ticks(low, high, 5);
    ASSERT_GE(ticks.size(), 2u);
    ASSERT_LE(ticks.size(), 6u);
    const double step = ticks[1] - ticks[0];
    const double digit = step / std::pow(10, std::floor(std::log10(step) + 1e-9));
    ASSERT_TRUE(std::abs(digit - 1) < 1e-6 || std::abs(digit - 2) < 1e-6 || std::abs(digit - 2.5) < 1e-6 ||
                std::abs(digit - 5) < 1e-6)
        << step;
    for (std::size_t k = 0; k < ticks.size(); ++k) {
      ASSERT_GE(ticks[k], low - slack);
      ASSERT_LE(ticks[k], high + slack);
      ASSERT_NEAR(ticks[k], ticks[0] + static_cast<double>(k) * step, slack);
    }
  }
}

TEST(Legend, NumbersOfTicksDoNotTouchAndTellTheScale) {
  constexpr double kText = 13;
  for (double height = 1.5 * kText; height < 400; height += 7) {
    for (const double range : {0.7, 1.0, 1.75, 1.9, 4.9, 8.6}) {
      for (const double minimum : {0.0, -range / 2, 3 * range}) {
        const std::vector<double> ticks = legend_ticks(minimum, minimum + range, legend_tick_count(height, kText));
        ASSERT_GE(ticks.size(), 2u);
        EXPECT_GE(ticks.front(), minimum - 1e-9);
        EXPECT_LE(ticks.back(), minimum + range + 1e-9);
        for (std::size_t i = 1; i < ticks.size(); ++i)
          EXPECT_GT((ticks[i] - ticks[i - 1]) / range * height, kText) << height << " pixels for " << range;
      }
    }
  }
}

TEST(Legend, TitleNamesTheUnitOfTheTicks) {
  EXPECT_EQ(legend_title({"stress", "Pa", 0, 3e6, {}, false}), "stress [MPa]");
  EXPECT_EQ(legend_title({"pressure", "Pa", -4e9, 3e6, {}, false}), "pressure [GPa]");
  EXPECT_EQ(legend_title({"utilization", "-", 0, 1, {}, false}), "utilization");
  EXPECT_EQ(legend_title({"speed", "m/s", 0, 4000, {}, false}), "speed [m/s]");
}

TEST(Legend, LeavesHalfOfThePictureOrIsLeftOut) {
  for (const float scale : {0.8f, 1.0f, 2.0f}) {
    EXPECT_TRUE(legend_fits({{0, 0}, {320 * scale, 180 * scale}}, scale));
    EXPECT_FALSE(legend_fits({{0, 0}, {200 * scale, 400 * scale}}, scale));
    EXPECT_FALSE(legend_fits({{0, 0}, {400 * scale, 150 * scale}}, scale));
  }
}

}  // namespace
}  // namespace griffith::ui
