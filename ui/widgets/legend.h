#pragma once

#include <imgui.h>

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "ui/widgets/fonts.h"

namespace griffith::ui {

/// Where in a picture the legend stands.
enum class LegendCorner { upper_right, upper_left, lower_right, lower_left };
inline constexpr std::array<LegendCorner, 4> kLegendCorners = {LegendCorner::upper_right, LegendCorner::upper_left,
                                                               LegendCorner::lower_right, LegendCorner::lower_left};

/// What the colours of a picture mean.
struct Legend {
  std::string title, unit;
  double minimum = 0, maximum = 1;       ///< values of the ends of the bar [unit]
  std::span<const std::uint8_t> colors;  ///< RGBA bytes, lowest value first
  bool locked = false;                   ///< the range was set by hand
  std::vector<int> histogram = {};       ///< how many values in each of equal parts of the range; may be empty
  std::optional<std::array<std::uint8_t, 3>> nan_color = {};  ///< RGB; where some values are not numbers
  LegendCorner corner = LegendCorner::upper_right;
};

/// A rectangle on the screen [pixels].
struct ScreenArea {
  ImVec2 minimum, maximum;
};

/// Whether a legend leaves half of the picture's width and height.
bool legend_fits(const ScreenArea& picture, float scale);

/// Round values inside [minimum, maximum], ascending, at least a `count`-th of it apart, two at least. The range must
/// not be empty; `count` >= 1.
std::vector<double> legend_ticks(double minimum, double maximum, double count);

/// How many ticks to ask for beside a bar of this height, so that their numbers do not touch. Both in pixels.
double legend_tick_count(double bar_height, double text_height);

/// "Von Mises stress [MPa]": the title with the unit and the prefix that the ticks are written in.
std::string legend_title(const Legend& legend);

/// The card that the legend is written on in that corner of a picture, clear of what else is written in the picture's
/// corners. `scale`: screen pixels per design pixel.
ScreenArea legend_card(const Legend& legend, LegendCorner corner, const Fonts& fonts, const ScreenArea& picture,
                       float scale);

/// Draws the legend on its card. `scale`: as above.
void draw_legend(ImDrawList* list, const Legend& legend, const Fonts& fonts, const ScreenArea& picture, float scale);

}  // namespace griffith::ui
