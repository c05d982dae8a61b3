#include "app/regress/compare_images.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

namespace griffith::app {
namespace {

constexpr int kColorChannels = 4;
constexpr int kDriftTile = 32;  // rounding cancels over as many pixels

using Color = std::array<std::uint8_t, 4>;

std::size_t offset(const render::Image& image, int x, int y) {
  return kColorChannels * (static_cast<std::size_t>(y) * image.width + x);
}

/// Returns the largest difference of a pixel's channels. `at`: index of its first byte.
int pixel_difference(const render::Image& golden, const render::Image& actual, std::size_t at) {
  int largest = 0;
  for (std::size_t i = at; i < at + kColorChannels; ++i)
    largest = std::max(largest, std::abs(actual.rgba[i] - golden.rgba[i]));
  return largest;
}

PixelMask image_mask(const render::Image& golden, const render::Image& actual, int tolerance) {
  PixelMask mask{golden.width, golden.height, {}};
  mask.off.reserve(golden.rgba.size() / kColorChannels);
  for (std::size_t at = 0; at < golden.rgba.size(); at += kColorChannels)
    mask.off.push_back(pixel_difference(golden, actual, at) > tolerance);
  return mask;
}

/// Returns the mean signed difference of the pixels in `rect` that are not off, in the channel where it is largest.
double drift_in(const render::Image& golden, const render::Image& actual, const PixelMask& mask,
                const PixelRect& rect) {
  std::array<std::int64_t, kColorChannels> sums = {};
  for (int y = rect.top; y < rect.top + rect.height; ++y)
    for (int x = rect.left; x < rect.left + rect.width; ++x) {
      const std::size_t at = offset(golden, x, y);
      if (mask.off[at / kColorChannels]) continue;
      for (std::size_t i = 0; i < kColorChannels; ++i) sums[i] += actual.rgba[at + i] - golden.rgba[at + i];
    }
  const auto largest = *std::ranges::max_element(sums, {}, [](std::int64_t sum) { return std::abs(sum); });
  return static_cast<double>(largest) / std::max(static_cast<double>(rect.width) * rect.height, 1.0);
}

void measure_drift(const render::Image& golden, const render::Image& actual, const PixelMask& mask,
                   ImageComparison& comparison) {
  comparison.drift = drift_in(golden, actual, mask, {0, 0, golden.width, golden.height});
  each_tile(golden.width, golden.height, kDriftTile, kDriftTile, [&](const PixelRect& tile) {
    const double drift = drift_in(golden, actual, mask, tile);
    if (std::abs(drift) <= std::abs(comparison.tile_drift)) return;
    comparison.tile_drift = drift;
    comparison.drift_tile = tile;
  });
}

std::string size_text(const render::Image& image) {
  return std::to_string(image.width) + "×" + std::to_string(image.height);
}

std::vector<ToleranceRule> image_rules(const ImageComparison& comparison, const ImageTolerance& tolerance) {
  std::vector<ToleranceRule> rules = off_rules(comparison.off, tolerance.off, "pixels");
  rules.push_back({"mean change of the other pixels", comparison.drift, tolerance.drift, "of 255"});
  rules.push_back({"mean change in a tile", comparison.tile_drift, tolerance.tile_drift, "of 255"});
  return rules;
}

std::string image_reason(const ImageComparison& comparison) {
  if (comparison.equal) return "identical";
  if (comparison.passed) return "within the tolerance, pixels off: " + std::to_string(comparison.off.count);
  return broken_rules(comparison.rules);
}

/// Returns the pixel's brightness, moved toward white.
std::uint8_t faint_gray(const render::Image& image, std::size_t at) {
  const double gray = 0.30 * image.rgba[at] + 0.59 * image.rgba[at + 1] + 0.11 * image.rgba[at + 2];
  return static_cast<std::uint8_t>(170 + gray / 3.2);
}

/// Returns the color that marks a difference too small to be off.
Color small_difference_color(const render::Image& golden, const render::Image& actual, std::size_t at) {
  int sum = 0;
  for (std::size_t i = at; i < at + kColorChannels; ++i) sum += actual.rgba[i] - golden.rgba[i];
  return sum >= 0 ? Color{240, 160, 40, 255} : Color{70, 130, 235, 255};
}

void paint(render::Image& image, int x, int y, const Color& color) {
  std::ranges::copy(color, image.rgba.begin() + static_cast<std::ptrdiff_t>(offset(image, x, y)));
}

/// Paints rings around the pixels that are off, with a width proportional to the picture.
void paint_rings(render::Image& image, const PixelMask& mask) {
  const int reach = std::max(2, image.width / 160);
  const auto is_off = [&](int x, int y) {
    return 0 <= x && x < mask.width && 0 <= y && y < mask.height &&
           mask.off[static_cast<std::size_t>(y) * mask.width + x];
  };
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      const bool is_inner = is_off(x - 1, y) && is_off(x + 1, y) && is_off(x, y - 1) && is_off(x, y + 1);
      if (!is_off(x, y) || is_inner) continue;
      for (int v = std::max(y - reach, 0); v <= std::min(y + reach, image.height - 1); ++v)
        for (int u = std::max(x - reach, 0); u <= std::min(x + reach, image.width - 1); ++u)
          if ((u - x) * (u - x) + (v - y) * (v - y) <= reach * reach) paint(image, u, v, {255, 190, 195, 255});
    }
}

}  // namespace

ImageComparison compare_images(const render::Image& golden, const render::Image& actual,
                               const ImageTolerance& tolerance) {
  ImageComparison comparison;
  if (golden.width != actual.width || golden.height != actual.height) {
    comparison.reason = "the size is " + size_text(actual) + ", that of the golden picture " + size_text(golden);
    return comparison;
  }
  comparison.equal = golden == actual;
  const PixelMask mask = image_mask(golden, actual, tolerance.channel);
  comparison.off = count_off(mask);
  for (std::size_t at = 0; at < golden.rgba.size(); at += kColorChannels)
    comparison.largest_difference = std::max(comparison.largest_difference, pixel_difference(golden, actual, at));
  measure_drift(golden, actual, mask, comparison);
  comparison.rules = image_rules(comparison, tolerance);
  comparison.passed = are_kept(comparison.rules);
  comparison.reason = image_reason(comparison);
  return comparison;
}

render::Image difference_image(const render::Image& golden, const render::Image& actual,
                               const ImageTolerance& tolerance) {
  render::Image image = actual;
  for (std::size_t at = 0; at < actual.rgba.size(); at += kColorChannels)
    std::fill_n(image.rgba.begin() + static_cast<std::ptrdiff_t>(at), 3, faint_gray(actual, at));
  const PixelMask mask = image_mask(golden, actual, tolerance.channel);
  paint_rings(image, mask);
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      const std::size_t at = offset(image, x, y);
      image.rgba[at + 3] = 255;
      if (mask.off[at / kColorChannels])
        paint(image, x, y, {215, 0, 40, 255});
      else if (pixel_difference(golden, actual, at) > 0)
        paint(image, x, y, small_difference_color(golden, actual, at));
    }
  return image;
}

}  // namespace griffith::app
