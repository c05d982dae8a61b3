#pragma once

#include <imgui.h>

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "ui/fonts.h"

namespace griffith::ui {

/// What the colours of a picture mean.
struct Legend {
  std::string title, unit;
  double minimum = 0, maximum = 1;       ///< values of the ends of the bar [unit]
  std::span<const std::uint8_t> colors;  ///< RGBA bytes, lowest value first
  bool locked = false;                   ///< the range was set by hand
  std::vector<int> histogram = {};       ///< how many values in each of equal parts of the range; may be empty
  std::optional<std::array<std::uint8_t, 3>> nan_color = {};  ///< RGB; where some values are not numbers
};

/// Round values inside [minimum, maximum], about `count` of them, ascending. The range must not be empty.
std::vector<double> legend_ticks(double minimum, double maximum, int count);

/// "Von Mises stress [MPa]": the title with the unit and the prefix that the ticks are written in.
std::string legend_title(const Legend& legend);

/// Draws the legend as a card into the rectangle's upper right corner. `scale`: screen pixels per design pixel.
/// Returns the card's lower left corner.
ImVec2 draw_legend(ImDrawList* list, const Legend& legend, const Fonts& fonts, ImVec2 minimum, ImVec2 maximum,
                   float scale);

}  // namespace griffith::ui
