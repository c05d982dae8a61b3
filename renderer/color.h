#pragma once

namespace griffith::render {

/// A color in the sRGB encoding, components in [0, 1], as in a color picker or a style sheet. Shaders decode it, shade
/// in linear light and encode once at the end.
struct Rgb {
  float r = 0, g = 0, b = 0;

  bool operator==(const Rgb&) const = default;
};

}  // namespace griffith::render
