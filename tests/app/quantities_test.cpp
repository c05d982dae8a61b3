#include "app/picture/quantities.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <random>

#include "app/shared/quantile.h"
#include "program.h"
#include "sim/scene/quantities.h"
#include "sim/world/world.h"

namespace griffith::app {
namespace {

TEST(Quantile, IsWhatLiesThereAmongTheSortedValues) {
  const float none = std::numeric_limits<float>::quiet_NaN(), endless = std::numeric_limits<float>::infinity();
  const std::vector<float> values = {7, none, 3, 9, -endless, 1, 5, endless};
  EXPECT_EQ(quantile(finite(values), 0), 1);
  EXPECT_EQ(quantile(finite(values), 0.5), 5);
  EXPECT_FLOAT_EQ(quantile(finite(values), 0.6f), 5.8f) << "between neighbors in proportion";
  EXPECT_EQ(quantile(finite(values), 1), 9);
  EXPECT_EQ(quantile(values, 0), -endless);
  EXPECT_EQ(quantile(values, 0.5), 5);
  EXPECT_EQ(quantile(values, 1), endless);
  EXPECT_EQ(quantile(std::vector{1.0f, endless, endless}, 0.75), endless);
  EXPECT_EQ(quantile(std::vector<double>{}, 0.5), 0);
  EXPECT_EQ(quantile(finite(std::vector{none, endless}), 0.5), 0);
  EXPECT_EQ(quantile(std::vector{none, none}, 0.5), 0);
}

TEST(Quantities, EveryQuantityOfTheMenuHasValuesAndARange) {
  World world(small_wall());
  for (int i = 0; i < 5; ++i) world.step();
  const Frame frame = world.frame();
  for (const Quantity* quantity : view_quantities()) {
    if (!quantity->has_values()) continue;
    const QuantityValues values = quantity_values(frame, *quantity);
    const std::size_t tets = frame.elements.tets.size();
    EXPECT_EQ(values.values.size(), values.place == ValuePlace::node   ? frame.nodes.positions.size()
                                    : values.place == ValuePlace::face ? 4 * tets
                                                                       : tets)
        << quantity->key;
    const Vec2 range = automatic_range(frame, quantity->key, values);
    EXPECT_LT(range[0], range[1]) << quantity->key;
  }
}

TEST(Quantities, RangeIgnoresOutliersAndNonsense) {
  const Frame frame;
  QuantityValues values;
  for (int i = 0; i <= 1000; ++i) values.values.push_back(static_cast<float>(i) * 1e4f);
  values.values.push_back(1e20f);
  values.values.push_back(std::numeric_limits<float>::quiet_NaN());
  values.values.push_back(std::numeric_limits<float>::infinity());
  const Vec2 range = automatic_range(frame, "von_mises", values);
  EXPECT_EQ(range[0], 0);
  EXPECT_GT(range[1], 9.5e6);
  EXPECT_LE(range[1], 1e7);
}

TEST(Quantities, RangeIsNeverEmptyAndHoldsZero) {
  const Frame frame;
  for (const char* key : {"von_mises", "pressure", "utilization", "displacement", "speed", "separation_eigenvalue"}) {
    for (const std::vector<float>& numbers :
         {std::vector<float>{}, {0, 0, 0}, {-1e-20f, -1e-20f}, {1e-20f}, {-5e6f, -4e6f}, {NAN}}) {
      const Vec2 range = automatic_range(frame, key, {ValuePlace::tet, numbers});
      EXPECT_LT(range[0], range[1]) << key;
      EXPECT_LE(range[0], 0) << key;
      EXPECT_GE(range[1], 0) << key;
    }
  }
}

/// A block that is held at its foot, and blocks that fall far away.
Scene block_and_falling_blocks(int falling) {
  Scene scene;
  BodyDescription& held = scene.bodies.emplace_back();
  held.shape = BoxShape{Vec3(1, 1, 1), Vec3(0.5, 0.5, 0.5), BoxPattern::five_tet};
  held.position = Vec3(0, 5, 0);
  held.supports.emplace_back().region = HalfSpaceRegion{Vec3(0, -0.5, 0), Vec3(0, -1, 0)};
  for (int i = 0; i < falling; ++i) {
    BodyDescription block = scene.bodies.front();
    block.supports.clear();
    block.position = Vec3(10.0 + 3 * i, 20, 0);
    scene.bodies.push_back(block);
  }
  return scene;
}

TEST(Quantities, RigidBodiesWithoutStressDoNotChangeItsRange) {
  World alone(block_and_falling_blocks(0)), among(block_and_falling_blocks(9));
  for (int i = 0; i < 5; ++i) alone.step(), among.step();
  ASSERT_TRUE(among.frame().bodies.back().rigid);
  const auto range_of = [](const Frame& frame, const char* key) {
    return automatic_range(frame, key, quantity_values(frame, *find_quantity(key)));
  };
  for (const char* key : {"von_mises", "pressure", "max_principal_stress", "separation_stress"})
    EXPECT_EQ(range_of(among.frame(), key), range_of(alone.frame(), key)) << key;
  EXPECT_NE(range_of(among.frame(), "speed"), range_of(alone.frame(), "speed")) << "which all bodies have";
}

TEST(Quantities, HistogramCountsEveryFiniteValueOnce) {
  std::mt19937 random(4);
  std::normal_distribution<float> normal;
  QuantityValues values;
  for (int i = 0; i < 1000; ++i) values.values.push_back(normal(random));
  values.values.insert(values.values.end(), {NAN, INFINITY, -1, 1, -50, 50});
  const std::vector<int> counts = histogram(values, Vec2(-1, 1), 20);
  ASSERT_EQ(counts.size(), 20u);
  EXPECT_EQ(std::accumulate(counts.begin(), counts.end(), 0), 1004);
  for (int bin = 1; bin < 19; ++bin) {
    const float low = -1 + 0.1f * static_cast<float>(bin);
    EXPECT_NEAR(counts[static_cast<std::size_t>(bin)],
                std::ranges::count_if(values.values, [low](float v) { return v >= low && v < low + 0.1f; }), 1);
  }
}

TEST(Quantities, ElementQualityIsOneForARegularTetAndFallsWithItsHeight) {
  const std::vector<std::array<NodeId, 4>> tets = {{NodeId(0), NodeId(1), NodeId(2), NodeId(3)}};
  std::vector<Vec3> points = {Vec3(1, 1, 1), Vec3(-1, 1, -1), Vec3(1, -1, -1), Vec3(-1, -1, 1)};
  Frame frame;
  frame.elements.tets = tets;
  frame.nodes.rest_positions = points;
  const auto element_quality = [&] { return quantity_values(frame, *find_quantity("element_quality")).values[0]; };
  EXPECT_NEAR(element_quality(), 1, 1e-7);
  const Vec3 base = (points[1] + points[2] + points[3]) / 3, tip = points[0];
  double last = 1;
  for (const double height : {0.5, 0.1, 0.01}) {
    points[0] = base + height * (tip - base);
    EXPECT_LT(element_quality(), last);
    last = element_quality();
  }
  EXPECT_LT(last, 0.02);
}

}  // namespace
}  // namespace griffith::app
