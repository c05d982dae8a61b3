#include "renderer/color_map.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace griffith::render {
namespace {

float linear(std::uint8_t encoded) {
  const float c = encoded / 255.0f;
  return c <= 0.04045f ? c / 12.92f : std::pow((c + 0.055f) / 1.055f, 2.4f);
}

float luminance(ColorMap map, int entry) {
  const std::uint8_t* color = &color_table(map)[4 * entry];
  return 0.2126f * linear(color[0]) + 0.7152f * linear(color[1]) + 0.0722f * linear(color[2]);
}

TEST(ColorMap, LuminanceOfSequentialMapsGrows) {
  for (const ColorMap map : {ColorMap::viridis, ColorMap::cividis}) {
    for (int entry = 1; entry < kColorTableSize; ++entry) {
      // Rounding to bytes may cost one step of the weakest channel.
      EXPECT_GT(luminance(map, entry), luminance(map, entry - 1) - 1e-3f) << color_map_name(map) << " " << entry;
    }
    for (int entry = 8; entry < kColorTableSize; ++entry) {
      EXPECT_GT(luminance(map, entry), luminance(map, entry - 8)) << color_map_name(map) << " " << entry;
    }
  }
}

TEST(ColorMap, HeatGoesFromLightGrayToDarkRed) {
  const Rgb low = color_map_color(ColorMap::heat, 0), high = color_map_color(ColorMap::heat, 1);
  EXPECT_NEAR(low.r, low.b, 0.03f);
  EXPECT_GT(low.r, 0.8f);
  EXPECT_GT(high.r, 3 * high.b);
  for (int entry = 8; entry < kColorTableSize; ++entry)
    EXPECT_LT(luminance(ColorMap::heat, entry), luminance(ColorMap::heat, entry - 8)) << entry;
}

TEST(ColorMap, CoolwarmIsDarkBlueAndDarkRedAroundALightGray) {
  const Rgb low = color_map_color(ColorMap::coolwarm, 0), middle = color_map_color(ColorMap::coolwarm, 0.5f),
            high = color_map_color(ColorMap::coolwarm, 1);
  EXPECT_GT(low.b, low.r + 0.4f);
  EXPECT_GT(high.r, high.b + 0.4f);
  EXPECT_NEAR(middle.r, middle.b, 0.02f);
  for (int entry = 1; entry <= 120; ++entry) {
    EXPECT_GT(luminance(ColorMap::coolwarm, entry), luminance(ColorMap::coolwarm, entry - 1) - 2e-3f);
    EXPECT_GT(luminance(ColorMap::coolwarm, 255 - entry), luminance(ColorMap::coolwarm, 256 - entry) - 2e-3f);
  }
}

TEST(ColorMap, ColorIsTheTablesEntry) {
  for (const ColorMap map : kColorMaps) {
    for (int entry = 0; entry < kColorTableSize; ++entry) {
      const Rgb color = color_map_color(map, (static_cast<float>(entry) + 0.5f) / kColorTableSize);
      EXPECT_EQ(std::lround(255 * color.g), color_table(map)[4 * entry + 1]);
    }
  }
}

TEST(ColorMap, ValuesBeyondTheRangeTakeTheEndsAndNanItsOwnColor) {
  const float infinity = std::numeric_limits<float>::infinity();
  for (const ColorMap map : kColorMaps) {
    EXPECT_EQ(color_map_color(map, -infinity), color_map_color(map, 0));
    EXPECT_EQ(color_map_color(map, 7), color_map_color(map, 1));
    const Rgb nan = color_map_color(map, std::numeric_limits<float>::quiet_NaN());
    for (int entry = 0; entry < kColorTableSize; ++entry) {
      const Rgb color = color_map_color(map, (static_cast<float>(entry) + 0.5f) / kColorTableSize);
      EXPECT_GT(std::abs(color.r - nan.r) + std::abs(color.g - nan.g) + std::abs(color.b - nan.b), 0.2f);
    }
  }
}

TEST(ColorMap, NamesAreFoundAgain) {
  for (const ColorMap map : kColorMaps) EXPECT_EQ(find_color_map(color_map_name(map)), map);
  EXPECT_FALSE(find_color_map("jet"));
}

}  // namespace
}  // namespace griffith::render
