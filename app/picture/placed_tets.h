#pragma once

#include <array>
#include <span>
#include <vector>

#include "sim/mesh/tet_mesh.h"
#include "sim/world/frame.h"

namespace griffith::app {

/// The tets of a scene body at rest, where they stand in the world.
struct PlacedTets {
  TetSoup soup;
  std::vector<TetId> tets;  ///< per tet of the soup
};

/// `frame`: before anything broke.
PlacedTets placed_tets(const Frame& frame, int scene_body);
/// Of any frame, with the corners that all tets had in the first one. The body is not remeshed.
PlacedTets placed_tets(const Frame& frame, std::span<const std::array<NodeId, 4>> first_tets, int scene_body);

}  // namespace griffith::app
