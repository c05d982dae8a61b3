#pragma once

namespace griffith::render {

/// A colour in the sRGB encoding, components in [0, 1]: what a colour picker or a style sheet shows. Shaders decode it,
/// shade in linear light and encode once at the end.
struct Rgb {
  float r = 0, g = 0, b = 0;

  bool operator==(const Rgb&) const = default;
};

}  // namespace griffith::render
