#pragma once

#include <array>
#include <span>
#include <vector>

#include "app/output/export_pieces.h"

namespace griffith::app {

/// The surfaces of all bodies as piece_surfaces() has them, but such that every body has one. Where splinters are
/// larger than tets, a body may own none: there it takes what of its neighbours' splinters lies in its own tets, so
/// that nothing is shown twice, and of the surface that the scene body shows what lies over them. Splinters that are
/// not convex, and that surface, may leave gaps at such cuts. `first_neighbours`: of the tets before anything broke.
/// The same points in the same order in all frames that have the topology of this one.
std::vector<PieceSurface> parted_surfaces(const Frame& frame, std::span<const Skin> skins,
                                          std::span<const std::array<TetId, 4>> first_neighbours);

}  // namespace griffith::app
