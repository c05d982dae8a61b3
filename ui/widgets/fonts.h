#pragma once

struct ImFont;

namespace griffith::ui {

/// Typefaces of the program, at the pixel size of the screen's scale.
struct Fonts {
  ImFont* regular = nullptr;
  ImFont* bold = nullptr;   ///< headings
  ImFont* small = nullptr;  ///< units, hints, ticks
};

/// Height of the small typeface in design pixels.
inline constexpr float kSmallText = 14;

/// Adds the embedded fonts to the current ImGui context. `scale`: screen pixels per design pixel.
Fonts load_fonts(float scale);

}  // namespace griffith::ui
