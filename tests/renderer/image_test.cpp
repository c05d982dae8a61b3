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
  EXPECT_EQ(decode_png(encode_png(image)), image);
  std::filesystem::remove_all(path.parent_path());
}

TEST(Image, WhatIsNoWholePictureIsRefused) {
  const std::string bytes = encode_png(noise(8, 8));
  for (const std::string& wrong : {std::string(), std::string("no image"), bytes.substr(0, 20), bytes.substr(0, 60)})
    EXPECT_THROW(decode_png(wrong), RenderError) << wrong.size();
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
  std::filesystem::remove_all(folder);
}

TEST(Image, PartHoldsItsPixels) {
  const Image image = noise(9, 7), part = part_of(image, 2, 3, 5, 4);
  EXPECT_EQ(part.width, 5);
  EXPECT_EQ(part.height, 4);
  for (int y = 0; y < 4; ++y)
    for (int x = 0; x < 5; ++x) EXPECT_EQ(part.pixel(x, y), image.pixel(x + 2, y + 3));
  EXPECT_EQ(part_of(image, 0, 0, 9, 7), image);
}

TEST(Image, SizesAreAveragedInLinearLight) {
  Image squares{64, 64, {}};
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x) {
      const std::uint8_t value = (x + y) % 2 == 0 ? 0 : 255;
      for (const std::uint8_t byte : {value, value, value, std::uint8_t{255}}) squares.rgba.push_back(byte);
    }
  const Image small = resized(squares, 8, 4);
  ASSERT_EQ(small.rgba.size(), 4u * 8 * 4);
  EXPECT_NEAR(small.pixel(4, 2)[0], 188, 2) << "half of the light, in the sRGB encoding";
  EXPECT_EQ(small.pixel(4, 2)[3], 255);
}

}  // namespace
}  // namespace griffith::render
