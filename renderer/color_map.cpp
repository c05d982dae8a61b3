#include "renderer/color_map.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace griffith::render {
namespace {

/// 0xRRGGBB at 52 equal steps; linear interpolation stays within 4/255 of the published 256 entries.
constexpr int kAnchors = 52;
using Anchors = std::array<std::uint32_t, kAnchors>;

// Smith and van der Walt (2015), CC0.
constexpr Anchors kViridis = {0x440154, 0x46085c, 0x471063, 0x481769, 0x481d6f, 0x482475, 0x472a7a, 0x46307e, 0x453781,
                              0x433d84, 0x414287, 0x3f4889, 0x3d4e8a, 0x3a538b, 0x38598c, 0x355e8d, 0x33638d, 0x31688e,
                              0x2e6d8e, 0x2c718e, 0x2a768e, 0x297b8e, 0x27808e, 0x25848e, 0x23898e, 0x218e8d, 0x20928c,
                              0x1f978b, 0x1e9c89, 0x1fa188, 0x21a585, 0x24aa83, 0x28ae80, 0x2eb37c, 0x35b779, 0x3dbc74,
                              0x46c06f, 0x50c46a, 0x5ac864, 0x65cb5e, 0x70cf57, 0x7cd250, 0x89d548, 0x95d840, 0xa2da37,
                              0xb0dd2f, 0xbddf26, 0xcae11f, 0xd8e219, 0xe5e419, 0xf1e51d, 0xfde725};

// Nuñez, Anderton and Renslow (2018): for all kinds of color vision.
constexpr Anchors kCividis = {0x00224e, 0x002656, 0x002a5f, 0x002d68, 0x003070, 0x083370, 0x163770, 0x203a6f, 0x273e6e,
                              0x2e416d, 0x34456c, 0x3a486c, 0x3f4c6c, 0x444f6c, 0x49536c, 0x4e566c, 0x535a6d, 0x575d6d,
                              0x5c616e, 0x60646f, 0x656870, 0x696b71, 0x6d6f72, 0x727274, 0x767676, 0x7a7a78, 0x7e7d78,
                              0x838179, 0x888578, 0x8d8878, 0x928c78, 0x969077, 0x9b9476, 0xa09875, 0xa59c74, 0xaaa073,
                              0xafa471, 0xb5a86f, 0xbaac6d, 0xbfb06b, 0xc4b468, 0xc9b965, 0xcfbd62, 0xd4c15f, 0xdac65b,
                              0xdfca57, 0xe5cf52, 0xead34c, 0xf0d846, 0xf6dd3f, 0xfce236, 0xfee838};

// Moreland (2009).
constexpr Anchors kCoolwarm = {0x3b4cc0, 0x4055c8, 0x465ecf, 0x4c66d6, 0x536edd, 0x5977e3, 0x5f7fe8, 0x6687ed, 0x6c8ff1,
                               0x7396f5, 0x7a9df8, 0x81a4fb, 0x88abfd, 0x8fb1fe, 0x96b7ff, 0x9dbdff, 0xa3c2fe, 0xaac7fd,
                               0xb1cbfc, 0xb7cff9, 0xbed2f6, 0xc4d5f3, 0xcad8ef, 0xcfdaea, 0xd5dbe5, 0xdadce0, 0xdfdbd9,
                               0xe4d9d2, 0xe9d5cb, 0xedd2c3, 0xf0cdbb, 0xf2c9b4, 0xf5c4ac, 0xf6bea4, 0xf7b89c, 0xf7b194,
                               0xf7aa8c, 0xf6a385, 0xf59c7d, 0xf39475, 0xf08b6e, 0xed8366, 0xe97a5f, 0xe57058, 0xe16751,
                               0xdc5d4a, 0xd65244, 0xd0473d, 0xca3b37, 0xc32e31, 0xbb1b2c, 0xb40426};

// Gray where nothing is loaded, so that debris is seen, then yellow, orange and red.
constexpr Anchors kHeat = {0xe8eaec, 0xe8e9e7, 0xe8e8e2, 0xe9e7dc, 0xe9e6d7, 0xe9e5d2, 0xe9e3cd, 0xeae2c7, 0xeae1c2,
                           0xeae0bd, 0xeadfb7, 0xebddb1, 0xecdbab, 0xecdaa6, 0xedd8a0, 0xedd69a, 0xeed594, 0xefd38e,
                           0xefd188, 0xf0d082, 0xf0cc7c, 0xf0c777, 0xefc371, 0xefbe6b, 0xefb965, 0xefb55f, 0xefb05a,
                           0xefab54, 0xeea64e, 0xeea248, 0xed9c44, 0xeb9541, 0xe98e3e, 0xe7873b, 0xe58038, 0xe37936,
                           0xe17233, 0xdf6b30, 0xdd642d, 0xdb5d2b, 0xd5552a, 0xcf4d29, 0xca4529, 0xc43d28, 0xbf3427,
                           0xb92c27, 0xb32526, 0xa72024, 0x9c1b23, 0x911621, 0x851120, 0x7a0c1e};

int channel(std::uint32_t rgb, int index) { return static_cast<int>(rgb >> (16 - 8 * index)) & 0xff; }

ColorTable interpolated(const Anchors& anchors) {
  ColorTable table;
  for (int entry = 0; entry < kColorTableSize; ++entry) {
    // Integers throughout: the preceding anchor, and the number of kColorTableSize - 1 parts beyond it.
    const int place = entry * (kAnchors - 1);
    const int before = std::min(place / (kColorTableSize - 1), kAnchors - 2);
    const int part = place - before * (kColorTableSize - 1);
    for (int k = 0; k < 3; ++k) {
      const int sum =
          channel(anchors[before], k) * (kColorTableSize - 1 - part) + channel(anchors[before + 1], k) * part;
      table[4 * entry + k] = static_cast<std::uint8_t>((2 * sum + kColorTableSize - 1) / (2 * (kColorTableSize - 1)));
    }
    table[4 * entry + 3] = 255;
  }
  return table;
}

}  // namespace

std::string_view color_map_name(ColorMap map) {
  switch (map) {
    case ColorMap::viridis:
      return "viridis";
    case ColorMap::coolwarm:
      return "coolwarm";
    case ColorMap::cividis:
      return "cividis";
    case ColorMap::heat:
      return "heat";
  }
  assert(false);
  return {};
}

std::optional<ColorMap> find_color_map(std::string_view name) {
  for (const ColorMap map : kColorMaps) {
    if (color_map_name(map) == name) return map;
  }
  return std::nullopt;
}

const ColorTable& color_table(ColorMap map) {
  static const std::array<ColorTable, kColorMaps.size()> tables = {interpolated(kViridis), interpolated(kCoolwarm),
                                                                   interpolated(kCividis), interpolated(kHeat)};
  return tables[static_cast<std::size_t>(map)];
}

Rgb color_map_color(ColorMap map, float t) {
  if (std::isnan(t)) return kNanColor;
  const float steps = std::clamp(t, 0.0f, 1.0f) * kColorTableSize;
  const int entry = std::min(static_cast<int>(steps), kColorTableSize - 1);
  const std::uint8_t* color = &color_table(map)[4 * entry];
  return {color[0] / 255.0f, color[1] / 255.0f, color[2] / 255.0f};
}

}  // namespace griffith::render
