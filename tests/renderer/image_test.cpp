#include "renderer/image.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <random>

#include "renderer/error.h"

namespace griffith::render {
namespace {

Image noise(int width, int height) {
  std::mt19937 random(7);
  Image image{width, height, {}};
  for (int i = 0; i < 4 * width * height; ++i) image.rgba.push_back(static_cast<std::uint8_t>(random()));
  return image;
}

std::filesystem::path fresh_folder(const std::string& name) {
  const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / ("griffith_" + name);
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  return folder;
}

TEST(Image, PngRoundTripKeepsEveryByte) {
  const std::filesystem::path path = fresh_folder("image_round_trip") / "noise.png";
  const Image image = noise(37, 21);
  std::ofstream(path, std::ios::binary) << encode_png(image);
  EXPECT_EQ(load_png(path), image);
  std::filesystem::remove_all(path.parent_path());
}

TEST(Image, ErrorsNameThePath) {
  const std::filesystem::path folder = fresh_folder("image_errors");
  const auto message = [](auto&& work) -> std::string {
    try {
      work();
    } catch (const RenderError& error) {
      return error.what();
    }
    return "no error";
  };
  std::ofstream(folder / "text.png") << "no image";
  EXPECT_THAT(message([&] { load_png(folder / "b.png"); }), testing::HasSubstr("b.png"));
  EXPECT_THAT(message([&] { load_png(folder / "text.png"); }), testing::HasSubstr("text.png"));
  EXPECT_THAT(message([&] { compare_images(noise(2, 2), noise(2, 3)); }), testing::HasSubstr("2x3"));
  std::filesystem::remove_all(folder);
}

TEST(Image, DifferenceCountsPixelsBeyondTheToleranceAndFindsTheWorstTile) {
  const Image a{100, 70, std::vector<std::uint8_t>(4 * 100 * 70, 100)};
  Image b = a;
  for (std::uint8_t& byte : b.rgba) byte += 4;  // everywhere just within the tolerance
  EXPECT_EQ(compare_images(a, b).pixels_off, 0);
  const auto spoil = [&b](int x, int y) { b.rgba[4 * (100 * y + x) + 1] = 105; };
  spoil(3, 3);
  for (int x = 96; x < 100; ++x) spoil(x, 65);  // in the corner's partial tile of 4 × 6 pixels
  const ImageDifference difference = compare_images(a, b);
  EXPECT_EQ(difference.pixels_off, 5);
  EXPECT_DOUBLE_EQ(difference.share_off, 5.0 / 7000);
  EXPECT_DOUBLE_EQ(difference.worst_tile_fraction, 4.0 / 24);
  EXPECT_EQ(difference.worst_tile_x, 96);
  EXPECT_EQ(difference.worst_tile_y, 64);
}

}  // namespace
}  // namespace griffith::render
