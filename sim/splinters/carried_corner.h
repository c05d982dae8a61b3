#pragma once

#include "sim/splinters/splinters.h"

namespace griffith {

/// Returns the tet that a part follows. `attached`: per part, as in SplinterState.
inline TetId carrier(std::span<const Splinter> splinters, std::span<const SplinterPart> parts,
                     std::span<const std::uint8_t> attached, int part) {
  return attached[part] ? parts[part].tet : splinters[parts[part].splinter].owner;
}

/// Returns the position of a corner [m] that follows the tet with these nodes: its own one (`attached`), or the owner.
inline Vec3 carried_position(const SplinterCorner& corner, bool attached, const std::array<NodeId, 4>& tet,
                             std::span<const Vec3> positions) {
  const Weights& weights = attached ? corner.weights : corner.owner_weights;
  Vec3 position = Vec3::Zero();
  for (int i = 0; i < 4; ++i) position += double(weights[i]) * positions[tet[i]];
  return position;
}

}  // namespace griffith
