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
  std::vector<std::uint8_t> rgba;  ///< 4 bytes per pixel (sRGB and alpha), rows from the top

  std::array<std::uint8_t, 4> pixel(int x, int y) const;
  bool operator==(const Image&) const = default;
};

/// Ids of the objects at each pixel, rows from the top.
struct IdImage {
  int width = 0, height = 0;      ///< [pixels]
  std::vector<std::int32_t> ids;  ///< kNoId for none

  bool operator==(const IdImage&) const = default;
};

/// Encodes a PNG file.
std::string encode_png(const Image& image);

/// Encodes a JPEG file, without transparency. `quality`: 1..100.
std::string encode_jpeg(const Image& image, int quality);

/// Decodes a PNG or JPEG file no larger than `max_width` by `max_height` [pixels]. Throws RenderError.
Image decode_image(std::string_view bytes, int max_width, int max_height);

/// Decodes a PNG file. Throws RenderError.
Image decode_png(std::string_view bytes);

/// Reads a PNG file. Throws RenderError naming the path.
Image load_png(const std::filesystem::path& path);

/// Returns a part of an image; it must lie inside.
Image part_of(const Image& image, int left, int top, int width, int height);

/// Resamples the image to a size of at least 1×1, averaged in linear light.
Image resized(const Image& image, int width, int height);

}  // namespace griffith::render
