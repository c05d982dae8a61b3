#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "renderer/color.h"

namespace griffith::render {

/// viridis and cividis for magnitudes (luminance grows with the value), coolwarm for signed values (symmetric range),
/// heat for the approach to a limit (gray to red, luminance falls).
enum class ColorMap { viridis, coolwarm, cividis, heat };

inline constexpr std::array<ColorMap, 4> kColorMaps = {ColorMap::viridis, ColorMap::coolwarm, ColorMap::cividis,
                                                       ColorMap::heat};

/// Returns "viridis", "coolwarm", "cividis" or "heat".
std::string_view color_map_name(ColorMap map);

/// Returns the map of that name, if there is one.
std::optional<ColorMap> find_color_map(std::string_view name);

inline constexpr int kColorTableSize = 256;

/// RGBA bytes (sRGB, opaque) at `kColorTableSize` equal steps of the map, lowest value first. Shaders read the same
/// table without interpolation, so that a pixel and the legend agree to the byte.
using ColorTable = std::array<std::uint8_t, 4 * kColorTableSize>;
const ColorTable& color_table(ColorMap map);

/// Returns the color of t in [0, 1], clamped beyond it: the table's entry ⌊256 t⌋. kNanColor if t is not a number.
Rgb color_map_color(ColorMap map, float t);

/// Color of missing values, which no map contains.
inline constexpr Rgb kNanColor = {204 / 255.0f, 51 / 255.0f, 204 / 255.0f};

}  // namespace griffith::render
