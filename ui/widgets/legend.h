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

/// Corner of the picture with the legend.
enum class LegendCorner { upper_right, upper_left, lower_right, lower_left };
inline constexpr std::array<LegendCorner, 4> kLegendCorners = {LegendCorner::upper_right, LegendCorner::upper_left,
                                                               LegendCorner::lower_right, LegendCorner::lower_left};

/// A color beside the scale.
struct LegendSample {
  std::array<std::uint8_t, 3> color;  ///< RGB
  std::string meaning;
};

/// Meaning of the colors of a picture.
struct Legend {
  std::string title, unit;
  double minimum = 0, maximum = 1;         ///< values at the ends of the bar [unit]
  std::span<const std::uint8_t> colors;    ///< RGBA bytes, lowest value first
  bool locked = false;                     ///< the range was set by the user
  std::vector<int> histogram = {};         ///< counts of values in equal parts of the range; may be empty
  std::vector<LegendSample> samples = {};  ///< colors of what has no value
  LegendCorner corner = LegendCorner::upper_right;
};

/// A rectangle on the screen [pixels].
struct ScreenArea {
  ImVec2 minimum, maximum;
};

/// True if a legend leaves half of the picture's width and height free.
bool legend_fits(const ScreenArea& picture, float scale);

/// Returns round values inside [minimum, maximum], ascending, spaced by at least a `count`-th of it; at least two. The
/// range must not be empty; `count` >= 1.
std::vector<double> legend_ticks(double minimum, double maximum, double count);

/// Returns the number of ticks next to a bar of this height whose numbers do not touch. Both in pixels.
double legend_tick_count(double bar_height, double text_height);

/// Returns the title with the unit and prefix of the ticks: "Von Mises stress [MPa]".
std::string legend_title(const Legend& legend);

/// Returns the card of the legend in that corner of a picture, clear of other texts in the picture's corners. `scale`:
/// screen pixels per design pixel.
ScreenArea legend_card(const Legend& legend, LegendCorner corner, const Fonts& fonts, const ScreenArea& picture,
                       float scale);

/// Draws the legend on its card. `scale`: as above.
void draw_legend(ImDrawList* list, const Legend& legend, const Fonts& fonts, const ScreenArea& picture, float scale);

}  // namespace griffith::ui
