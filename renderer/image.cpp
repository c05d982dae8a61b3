#include "renderer/image.h"

#include <stb_image.h>
#include <stb_image_resize.h>
#include <stb_image_write.h>

#include <cassert>
#include <climits>
#include <memory>
#include <new>
#include <string>

#include "renderer/error.h"

namespace griffith::render {
namespace {

constexpr int kChannels = 4;

void append_bytes(void* to, void* data, int size) {
  static_cast<std::string*>(to)->append(static_cast<const char*>(data), static_cast<std::size_t>(size));
}

int size_of(std::string_view bytes) { return bytes.size() > INT_MAX ? 0 : static_cast<int>(bytes.size()); }

const stbi_uc* data_of(std::string_view bytes) { return reinterpret_cast<const stbi_uc*>(bytes.data()); }

}  // namespace

std::array<std::uint8_t, 4> Image::pixel(int x, int y) const {
  assert(0 <= x && x < width && 0 <= y && y < height);
  const std::size_t at = kChannels * (static_cast<std::size_t>(y) * width + x);
  return {rgba[at], rgba[at + 1], rgba[at + 2], rgba[at + 3]};
}

std::string encode_png(const Image& image) {
  std::string bytes;
  if (!stbi_write_png_to_func(append_bytes, &bytes, image.width, image.height, kChannels, image.rgba.data(),
                              kChannels * image.width))
    throw std::bad_alloc();  // its only error
  return bytes;
}

std::string encode_jpeg(const Image& image, int quality) {
  std::string bytes;
  if (!stbi_write_jpg_to_func(append_bytes, &bytes, image.width, image.height, kChannels, image.rgba.data(), quality))
    throw std::bad_alloc();  // as above
  return bytes;
}

Image decode_image(std::string_view bytes, int max_width, int max_height) {
  int width = 0, height = 0, channels = 0;
  if (!stbi_info_from_memory(data_of(bytes), size_of(bytes), &width, &height, &channels))
    throw RenderError(std::string("can't read an image: ") + stbi_failure_reason());
  if (width > max_width || height > max_height)
    throw RenderError("can't read an image: it has more than " + std::to_string(max_width) + "x" +
                      std::to_string(max_height) + " pixels");
  return decode_png(bytes);
}

Image decode_png(std::string_view bytes) {
  Image image;
  int channels = 0;
  const std::unique_ptr<stbi_uc, decltype(&stbi_image_free)> pixels(
      stbi_load_from_memory(data_of(bytes), size_of(bytes), &image.width, &image.height, &channels, kChannels),
      stbi_image_free);
  if (!pixels) throw RenderError(std::string("can't read an image: ") + stbi_failure_reason());
  image.rgba.assign(pixels.get(), pixels.get() + std::size_t{kChannels} * image.width * image.height);
  return image;
}

Image load_png(const std::filesystem::path& path) {
  Image image;
  int channels = 0;
  const std::unique_ptr<stbi_uc, decltype(&stbi_image_free)> pixels(
      stbi_load(path.c_str(), &image.width, &image.height, &channels, kChannels), stbi_image_free);
  if (!pixels) throw RenderError("can't read the image " + path.string() + ": " + stbi_failure_reason());
  image.rgba.assign(pixels.get(), pixels.get() + std::size_t{kChannels} * image.width * image.height);
  return image;
}

Image part_of(const Image& image, int left, int top, int width, int height) {
  assert(left >= 0 && top >= 0 && left + width <= image.width && top + height <= image.height);
  Image part{width, height, {}};
  for (int y = top; y < top + height; ++y) {
    const auto row = image.rgba.begin() + kChannels * (static_cast<std::ptrdiff_t>(y) * image.width + left);
    part.rgba.insert(part.rgba.end(), row, row + std::ptrdiff_t{kChannels} * width);
  }
  return part;
}

Image resized(const Image& image, int width, int height) {
  Image result{width, height, std::vector<std::uint8_t>(std::size_t{kChannels} * width * height)};
  constexpr int kAlphaChannel = 3;
  if (!stbir_resize_uint8_srgb(image.rgba.data(), image.width, image.height, 0, result.rgba.data(), width, height, 0,
                               kChannels, kAlphaChannel, 0))
    throw std::bad_alloc();  // as above
  return result;
}

}  // namespace griffith::render
