#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace griffith::render {

struct Image {
  int width = 0, height = 0;       ///< [pixels]
  std::vector<std::uint8_t> rgba;  ///< 4 bytes a pixel (sRGB and alpha), rows from the top

  std::array<std::uint8_t, 4> pixel(int x, int y) const;
  bool operator==(const Image&) const = default;
};

/// What is drawn at each pixel, rows from the top.
struct IdImage {
  int width = 0, height = 0;      ///< [pixels]
  std::vector<std::int32_t> ids;  ///< kNoId where nothing is

  bool operator==(const IdImage&) const = default;
};

/// The bytes of a PNG file.
std::string encode_png(const Image& image);

/// The bytes of a JPEG file, without transparency. `quality`: 1..100.
std::string encode_jpeg(const Image& image, int quality);

/// The picture in the bytes of a PNG or JPEG file, if it is no larger than `max_width` by `max_height` [pixels]. Throws
/// RenderError.
Image decode_image(std::string_view bytes, int max_width, int max_height);

/// The picture in the bytes of a PNG file. Throws RenderError.
Image decode_png(std::string_view bytes);

/// Throws RenderError naming the path.
Image load_png(const std::filesystem::path& path);

/// A part of an image; it must lie inside.
Image part_of(const Image& image, int left, int top, int width, int height);

/// The image in another size of at least 1×1, averaged in linear light.
Image resized(const Image& image, int width, int height);

}  // namespace griffith::render
