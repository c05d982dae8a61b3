#include "app/regress/compare_images.h"

#include <gtest/gtest.h>

namespace griffith::app {
namespace {

using render::Image;

Image gray(int width, int height) {
  Image image{width, height, {}};
  for (int i = 0; i < width * height; ++i)
    for (const std::uint8_t byte : {100, 100, 100, 255}) image.rgba.push_back(byte);
  return image;
}

void add_to(Image& image, const PixelRect& rect, int by, std::size_t channel = 1) {
  for (int y = rect.top; y < rect.top + rect.height; ++y)
    for (int x = rect.left; x < rect.left + rect.width; ++x)
      image.rgba[4 * (static_cast<std::size_t>(y) * image.width + x) + channel] += static_cast<std::uint8_t>(by);
}

TEST(CompareImages, EqualOnesPass) {
  const ImageComparison comparison = compare_images(gray(320, 180), gray(320, 180));
  EXPECT_TRUE(comparison.passed && comparison.equal);
  EXPECT_EQ(comparison.reason, "identical");
}

TEST(CompareImages, OtherSizesFail) {
  const ImageComparison comparison = compare_images(gray(320, 180), gray(320, 181));
  EXPECT_FALSE(comparison.passed);
  EXPECT_EQ(comparison.reason, "the size is 320×181, that of the golden picture 320×180");
}

/// At the limits and one beyond them: 0.05 % of 320×200 pixels are 32.
TEST(CompareImages, PixelsOffAreCountedOverThePicture) {
  const Image golden = gray(320, 200);
  Image actual = golden;
  for (int i = 0; i < 32; ++i) add_to(actual, {9 * i, 5 * i, 1, 1}, 5);
  EXPECT_EQ(compare_images(golden, actual).off.count, 32);
  EXPECT_TRUE(compare_images(golden, actual).passed);
  add_to(actual, {319, 199, 1, 1}, -5);
  EXPECT_FALSE(compare_images(golden, actual).passed);
}

/// 5 % of 16×16 pixels are 12.8, and tiles overlap, so it does not matter where the spot is.
TEST(CompareImages, PixelsOffAreCountedInTiles) {
  const Image golden = gray(640, 360);
  for (int left : {0, 3, 15, 317, 636})
    for (int top : {0, 14, 100, 357}) {
      Image actual = golden;
      add_to(actual, {left, top, 4, 3}, 100);
      EXPECT_TRUE(compare_images(golden, actual).passed) << left << " " << top;
      add_to(actual, {left == 0 ? 4 : left - 1, top, 1, 1}, 100);
      const ImageComparison comparison = compare_images(golden, actual);
      EXPECT_FALSE(comparison.passed) << left << " " << top;
      EXPECT_EQ(comparison.off.count, 13);
      EXPECT_DOUBLE_EQ(comparison.off.worst_tile_fraction, 13.0 / 256);
      const PixelRect tile = comparison.off.worst_tile;
      EXPECT_TRUE(tile.left <= left && left < tile.left + 16 && tile.top <= top && top < tile.top + 16);
    }
}

TEST(CompareImages, TheLargestDifferenceIsReportedAndNoRule) {
  const Image golden = gray(320, 180);
  Image actual = golden;
  add_to(actual, {50, 50, 2, 1}, 155);
  const ImageComparison comparison = compare_images(golden, actual);
  EXPECT_EQ(comparison.largest_difference, 155);
  EXPECT_TRUE(comparison.passed);
}

/// No pixel is off, yet many change in one direction.
TEST(CompareImages, DriftIsSeenInThePictureAndInATile) {
  const Image golden = gray(320, 160);
  Image actual = golden;
  for (int i = 0; i < 160; ++i) add_to(actual, {2 * i, 0, 1, 5}, 1, 2);  // 800 of 51,200, in five tiles of rows
  ImageComparison comparison = compare_images(golden, actual);
  EXPECT_EQ(comparison.off.count, 0);
  EXPECT_DOUBLE_EQ(comparison.drift, 800.0 / 51200);
  EXPECT_TRUE(comparison.passed) << comparison.reason;
  for (int i = 0; i < 160; ++i) add_to(actual, {2 * i, 64, 1, 5}, 1, 2);
  comparison = compare_images(golden, actual);
  EXPECT_FALSE(comparison.passed) << comparison.reason;
  EXPECT_LT(std::abs(comparison.tile_drift), 0.25);
  actual = golden;
  add_to(actual, {64, 32, 32, 8}, -1, 0);
  EXPECT_TRUE(compare_images(golden, actual).passed);
  add_to(actual, {64, 50, 1, 1}, -1, 0);
  comparison = compare_images(golden, actual);
  EXPECT_FALSE(comparison.passed) << comparison.reason;
  EXPECT_LT(std::abs(comparison.drift), 0.03);
  EXPECT_DOUBLE_EQ(comparison.tile_drift, -0.25 - 1.0 / 1024);
  EXPECT_EQ(comparison.drift_tile, (PixelRect{64, 32, 32, 32}));
}

/// One flipped pixel is a quarter of the drift that a tile may have, and must not add to it.
TEST(CompareImages, PixelsOffDoNotDrift) {
  const Image golden = gray(320, 180);
  Image actual = golden;
  add_to(actual, {40, 40, 3, 3}, 150);
  EXPECT_EQ(compare_images(golden, actual).tile_drift, 0);
}

TEST(CompareImages, ReasonsNameTheBrokenRulesAlone) {
  const Image golden = gray(320, 200);
  Image actual = golden;
  add_to(actual, {16, 16, 16, 16}, 90);
  EXPECT_EQ(compare_images(golden, actual).reason,
            "pixels off in the picture: 0.4 % (at most 0.05 %); pixels off in the worst tile: 100 % (at most 5 %)");
  actual = golden;
  for (std::uint8_t& byte : actual.rgba) byte = static_cast<std::uint8_t>(byte - 1);
  EXPECT_EQ(
      compare_images(golden, actual).reason,
      "mean change of the other pixels: -1 of 255 (at most 0.03 of 255); mean change in a tile: -1 of 255 (at most "
      "0.25 of 255)");
  EXPECT_EQ(rule_text({"", 0, 0, "of 255"}, -1e-5), "0 of 255");
}

TEST(CompareImages, WithoutToleranceEveryBitCounts) {
  const ImageTolerance none{0, {0, 0}, 0, 0};
  const Image golden = gray(320, 200);
  Image actual = golden;
  EXPECT_TRUE(compare_images(golden, actual, none).passed);
  add_to(actual, {77, 99, 1, 1}, 1);
  EXPECT_FALSE(compare_images(golden, actual, none).passed);
}

TEST(CompareImages, TransparencyCounts) {
  const Image golden = gray(64, 64);
  Image actual = golden;
  add_to(actual, {0, 0, 32, 32}, -100, 3);
  EXPECT_EQ(compare_images(golden, actual).off.count, 32 * 32);
}

TEST(CompareImages, PicturesSmallerThanATileAreOneTile) {
  const Image golden = gray(5, 4);
  Image actual = golden;
  add_to(actual, {4, 3, 1, 1}, 9);
  const ImageComparison comparison = compare_images(golden, actual);
  EXPECT_EQ(comparison.off.worst_tile, (PixelRect{0, 0, 5, 4}));
  EXPECT_FALSE(comparison.passed);
}

TEST(CompareImages, OneDifferentPixelIsMarkedForAllToSee) {
  const Image golden = gray(640, 360);
  Image actual = golden;
  add_to(actual, {300, 200, 1, 1}, 60);
  add_to(actual, {10, 10, 1, 1}, 2);
  add_to(actual, {12, 10, 1, 1}, -2);
  const Image difference = difference_image(golden, actual);
  using Pixel = std::array<std::uint8_t, 4>;
  EXPECT_EQ(difference.pixel(300, 200), (Pixel{215, 0, 40, 255}));
  EXPECT_EQ(difference.pixel(303, 200), (Pixel{255, 190, 195, 255}));
  EXPECT_EQ(difference.pixel(10, 10), (Pixel{240, 160, 40, 255}));
  EXPECT_EQ(difference.pixel(12, 10), (Pixel{70, 130, 235, 255}));
  const Pixel faint = difference.pixel(500, 300);
  EXPECT_TRUE(faint[0] > 180 && faint[0] == faint[1] && faint[1] == faint[2]);
}

}  // namespace
}  // namespace griffith::app
