#include "app/regress/pixel_mask.h"

#include <algorithm>
#include <cstdio>
#include <numeric>

namespace griffith::app {
namespace {

constexpr int kTile = 16;  // a missing letter is a twentieth of it
constexpr int kTileSpacing = kTile / 2;

int count_in(const PixelMask& mask, const PixelRect& rect) {
  int count = 0;
  for (int y = rect.top; y < rect.top + rect.height; ++y) {
    const auto row = mask.off.begin() + static_cast<std::ptrdiff_t>(y) * mask.width + rect.left;
    count = std::accumulate(row, row + rect.width, count);
  }
  return count;
}

}  // namespace

void each_tile(int width, int height, int side, int spacing, const std::function<void(const PixelRect&)>& visit) {
  const int last_left = std::max(width - side, 0), last_top = std::max(height - side, 0);
  for (int y = 0; y < last_top + spacing; y += spacing)
    for (int x = 0; x < last_left + spacing; x += spacing)
      visit({std::min(x, last_left), std::min(y, last_top), std::min(side, width), std::min(side, height)});
}

OffPixels count_off(const PixelMask& mask) {
  OffPixels off;
  off.count = std::accumulate(mask.off.begin(), mask.off.end(), 0);
  off.fraction = off.count / std::max(static_cast<double>(mask.off.size()), 1.0);
  each_tile(mask.width, mask.height, kTile, kTileSpacing, [&](const PixelRect& tile) {
    const double fraction = count_in(mask, tile) / std::max(static_cast<double>(tile.width) * tile.height, 1.0);
    if (fraction <= off.worst_tile_fraction) return;
    off.worst_tile_fraction = fraction;
    off.worst_tile = tile;
  });
  return off;
}

std::vector<ToleranceRule> off_rules(const OffPixels& off, const OffLimits& limits, const std::string& what) {
  return {{what + " off in the picture", 100 * off.fraction, 100 * limits.picture, "%"},
          {what + " off in the worst tile", 100 * off.worst_tile_fraction, 100 * limits.tile, "%"}};
}

bool are_kept(std::span<const ToleranceRule> rules) { return std::ranges::all_of(rules, &ToleranceRule::is_kept); }

std::string rule_text(const ToleranceRule& rule, double value) {
  const double rounded = std::round(1000 * value) / 1000 + 0.0;  // no "-0"
  char text[64];
  std::snprintf(text, sizeof text, "%.3g %s", rounded, rule.unit.c_str());
  return text;
}

std::string broken_rules(std::span<const ToleranceRule> rules) {
  std::string text;
  for (const ToleranceRule& rule : rules) {
    if (rule.is_kept()) continue;
    text += (text.empty() ? "" : "; ") + rule.name + ": " + rule_text(rule, rule.found) + " (at most " +
            rule_text(rule, rule.allowed) + ")";
  }
  return text;
}

}  // namespace griffith::app
