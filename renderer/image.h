#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace griffith::render {

struct Image {
  int width = 0, height = 0;       ///< [pixels]
  std::vector<std::uint8_t> rgba;  ///< 4 bytes a pixel (sRGB and alpha), rows from the top

  std::array<std::uint8_t, 4> pixel(int x, int y) const;
  bool operator==(const Image&) const = default;
};

/// The bytes of a PNG file.
std::string encode_png(const Image& image);

/// Throws RenderError naming the path.
Image load_png(const std::filesystem::path& path);

/// How far two images of one size are apart. A pixel is off if a channel differs by more than 4/255.
struct ImageDifference {
  int pixels_off = 0;
  double share_off = 0;                    ///< of all pixels, 0 to 1
  double worst_tile_fraction = 0;          ///< the largest share in any 32×32 tile, 0 to 1
  int worst_tile_x = 0, worst_tile_y = 0;  ///< its top left pixel
};

/// Throws RenderError if the sizes differ.
ImageDifference compare_images(const Image& a, const Image& b);

}  // namespace griffith::render
