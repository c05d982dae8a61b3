#pragma once

#include <cmath>

namespace griffith::render {

/// A color in the sRGB encoding, components in [0, 1], as in a color picker or a style sheet. Shaders decode it, shade
/// in linear light and encode once at the end.
struct Rgb {
  float r = 0, g = 0, b = 0;

  bool operator==(const Rgb&) const = default;
};

/// Decodes a channel of sRGB to linear light (IEC 61966-2-1).
inline float linear_from_srgb(float channel) {
  return channel <= 0.04045f ? channel / 12.92f : std::pow((channel + 0.055f) / 1.055f, 2.4f);
}

/// Encodes linear light as a channel of sRGB.
inline float srgb_from_linear(float light) {
  return light <= 0.0031308f ? 12.92f * light : 1.055f * std::pow(light, 1 / 2.4f) - 0.055f;
}

}  // namespace griffith::render
