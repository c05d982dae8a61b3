#pragma once

#include <array>
#include <span>
#include <vector>

#include "app/output/export_pieces.h"

namespace griffith::app {

/// Returns the surfaces of all bodies like piece_surfaces(), but none is empty. A body smaller than its splinters may
/// own none. It then takes the parts of its neighbors' splinters within its own tets, and the parts of the scene body's
/// surface over them, so that nothing is shown twice. Non-convex splinters and such surfaces may leave gaps at the
/// cuts. `first_neighbors`: of the tets before any fracture. Frames of the same topology give the same points in the
/// same order.
std::vector<PieceSurface> parted_surfaces(const Frame& frame, std::span<const Skin> skins,
                                          std::span<const std::array<TetId, 4>> first_neighbors);

}  // namespace griffith::app
