#include "app/output/id_picture.h"

#include <cstdint>

#include "renderer/error.h"

namespace griffith::app {
namespace {

constexpr std::uint32_t kColors = 1u << 24;
constexpr std::uint32_t kSpread = 0x9E3779 | 1;  // odd, so that multiplication modulo 2^24 is invertible

/// Returns the inverse of `factor` modulo 2^32, and so 2^24: Newton's iteration doubles the correct bits.
constexpr std::uint32_t inverse(std::uint32_t factor) {
  std::uint32_t result = factor;
  for (int i = 0; i < 5; ++i) result *= 2 - factor * result;
  return result;
}
static_assert(kSpread * inverse(kSpread) == 1);

}  // namespace

render::Image id_picture(const render::IdImage& ids) {
  render::Image picture{ids.width, ids.height, {}};
  picture.rgba.reserve(4 * ids.ids.size());
  for (const std::int32_t id : ids.ids) {
    const std::uint32_t number = static_cast<std::uint32_t>(id) + 1;  // 0 for kNoId
    if (number >= kColors) throw render::RenderError("there is no color for the id " + std::to_string(id));
    const std::uint32_t color = number * kSpread % kColors;
    for (const int shift : {16, 8, 0}) picture.rgba.push_back(static_cast<std::uint8_t>(color >> shift));
    picture.rgba.push_back(255);
  }
  return picture;
}

render::IdImage ids_of_picture(const render::Image& picture) {
  render::IdImage ids{picture.width, picture.height, {}};
  ids.ids.reserve(picture.rgba.size() / 4);
  for (std::size_t at = 0; at < picture.rgba.size(); at += 4) {
    const auto byte = [&](std::size_t i) { return std::uint32_t{picture.rgba[at + i]}; };
    const std::uint32_t color = byte(0) << 16 | byte(1) << 8 | byte(2);
    ids.ids.push_back(static_cast<std::int32_t>(color * inverse(kSpread) % kColors) - 1);
  }
  return ids;
}

}  // namespace griffith::app
