#pragma once

#include <vector>

#include "sim/mesh/tet_mesh.h"
#include "sim/world/frame.h"

namespace griffith::app {

/// The tets of a scene body at rest, where they stand in the world.
struct PlacedTets {
  TetSoup soup;
  std::vector<TetId> tets;  ///< per tet of the soup
};

PlacedTets placed_tets(const Frame& frame, int scene_body);

}  // namespace griffith::app
