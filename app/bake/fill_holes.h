#pragma once

#include <array>
#include <vector>

#include "app/output/export_pieces.h"

namespace griffith::app {

/// Triangles over the points of a surface that close it: its open edges are chained into loops, and each loop is
/// filled by the triangulation of least area (Barequet & Sharir 1995). Points nearer to each other than 1e-5 of the
/// surface's diagonal count as one; gaps narrower than that stay.
std::vector<std::array<int, 3>> hole_triangles(const PieceSurface& surface);

/// Adds such triangles as polygons that a crack laid bare.
void fill_holes(PieceSurface& surface, const std::vector<std::array<int, 3>>& triangles);

}  // namespace griffith::app
