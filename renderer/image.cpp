#include "renderer/image.h"

#include <stb_image.h>
#include <stb_image_write.h>

#include <algorithm>
#include <cassert>
#include <cstdlib>
#include <new>
#include <string>

#include "renderer/error.h"

namespace griffith::render {
namespace {

constexpr int kChannels = 4;

bool is_off(const std::uint8_t* a, const std::uint8_t* b) {
  constexpr int kTolerance = 4;
  for (int channel = 0; channel < kChannels; ++channel) {
    if (std::abs(a[channel] - b[channel]) > kTolerance) return true;
  }
  return false;
}

int count_off(const Image& a, const Image& b, int left, int top, int right, int bottom) {
  int count = 0;
  for (int y = top; y < bottom; ++y) {
    for (int x = left; x < right; ++x) {
      const std::size_t at = kChannels * (static_cast<std::size_t>(y) * a.width + x);
      count += is_off(&a.rgba[at], &b.rgba[at]);
    }
  }
  return count;
}

}  // namespace

std::array<std::uint8_t, 4> Image::pixel(int x, int y) const {
  assert(0 <= x && x < width && 0 <= y && y < height);
  const std::size_t at = kChannels * (static_cast<std::size_t>(y) * width + x);
  return {rgba[at], rgba[at + 1], rgba[at + 2], rgba[at + 3]};
}

std::string encode_png(const Image& image) {
  std::string bytes;
  const auto append = [](void* to, void* data, int size) {
    static_cast<std::string*>(to)->append(static_cast<const char*>(data), static_cast<std::size_t>(size));
  };
  if (!stbi_write_png_to_func(append, &bytes, image.width, image.height, kChannels, image.rgba.data(),
                              kChannels * image.width))
    throw std::bad_alloc();  // the one thing that it fails for
  return bytes;
}

Image load_png(const std::filesystem::path& path) {
  Image image;
  int channels = 0;
  stbi_uc* pixels = stbi_load(path.c_str(), &image.width, &image.height, &channels, kChannels);
  if (!pixels) throw RenderError("can't read the image " + path.string() + ": " + stbi_failure_reason());
  image.rgba.assign(pixels, pixels + static_cast<std::size_t>(kChannels) * image.width * image.height);
  stbi_image_free(pixels);
  return image;
}

ImageDifference compare_images(const Image& a, const Image& b) {
  if (a.width != b.width || a.height != b.height) {
    throw RenderError("images of different size: " + std::to_string(a.width) + "x" + std::to_string(a.height) +
                      " and " + std::to_string(b.width) + "x" + std::to_string(b.height));
  }
  constexpr int kTile = 32;
  ImageDifference difference;
  for (int top = 0; top < a.height; top += kTile) {
    for (int left = 0; left < a.width; left += kTile) {
      const int right = std::min(left + kTile, a.width), bottom = std::min(top + kTile, a.height);
      const int off = count_off(a, b, left, top, right, bottom);
      const double fraction = static_cast<double>(off) / ((right - left) * (bottom - top));
      difference.pixels_off += off;
      if (fraction > difference.worst_tile_fraction) {
        difference.worst_tile_fraction = fraction;
        difference.worst_tile_x = left;
        difference.worst_tile_y = top;
      }
    }
  }
  const int pixels = a.width * a.height;
  difference.share_off = pixels > 0 ? static_cast<double>(difference.pixels_off) / pixels : 0;
  return difference;
}

}  // namespace griffith::render
