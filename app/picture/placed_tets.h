#pragma once

#include <array>
#include <span>
#include <vector>

#include "sim/mesh/tet_mesh.h"
#include "sim/world/output/frame.h"

namespace griffith::app {

/// Tets of a scene body at rest in its initial placement.
struct PlacedTets {
  TetSoup soup;
  std::vector<TetId> tets;  ///< tet of the frame for each tet of the soup
};

/// `frame`: before any fracture.
PlacedTets placed_tets(const Frame& frame, int scene_body);
/// For any frame, with the initial corners of all tets. The body must not be remeshed.
PlacedTets placed_tets(const Frame& frame, std::span<const std::array<NodeId, 4>> first_tets, int scene_body);

}  // namespace griffith::app
