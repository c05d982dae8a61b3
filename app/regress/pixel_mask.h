#pragma once

#include <cmath>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace griffith::app {

/// A rectangle of pixels, from the top left.
struct PixelRect {
  int left = 0, top = 0, width = 0, height = 0;

  bool operator==(const PixelRect&) const = default;
};

/// Calls `visit` with the tiles that cover a picture, `spacing` apart. All are squares of `side`; the last ones at the
/// right and bottom are moved inward. A smaller picture is one tile in that direction.
void each_tile(int width, int height, int side, int spacing, const std::function<void(const PixelRect&)>& visit);

/// Pixels that are off in a comparison of two pictures of one size.
struct PixelMask {
  int width = 0, height = 0;
  std::vector<std::uint8_t> off;  ///< 1 if the pixel is off; rows from the top
};

/// Counts of pixels that are off, for the rules.
struct OffPixels {
  int count = 0;
  double fraction = 0;             ///< fraction of the picture, 0 to 1
  PixelRect worst_tile;            ///< 16×16 pixels, tiles 8 apart
  double worst_tile_fraction = 0;  ///< fraction of that tile, 0 to 1
};

OffPixels count_off(const PixelMask& mask);

/// Allowed fractions of pixels that are off, in the picture and in any tile.
struct OffLimits {
  double picture = 5e-4, tile = 0.05;
};

/// A measured number with its limit.
struct ToleranceRule {
  std::string name;  ///< "pixels off in the worst tile"
  double found = 0, allowed = 0;
  std::string unit;

  bool is_kept() const { return std::abs(found) <= allowed; }
};

/// Returns the rules about pixels that are off. `what`: "pixels" or "ids".
std::vector<ToleranceRule> off_rules(const OffPixels& off, const OffLimits& limits, const std::string& what);

bool are_kept(std::span<const ToleranceRule> rules);

/// Formats a value in the rule's unit with at most three decimals: "75 %".
std::string rule_text(const ToleranceRule& rule, double value);

/// Lists the broken rules: "pixels off in the worst tile: 75 % (at most 5 %); …".
std::string broken_rules(std::span<const ToleranceRule> rules);

}  // namespace griffith::app
