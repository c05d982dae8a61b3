#pragma once

#include <array>
#include <vector>

#include "app/output/export_pieces.h"

namespace griffith::app {

/// Returns triangles over the points of a surface that close it. Its open edges are chained into loops, and each loop
/// is filled by the triangulation of least area (Barequet & Sharir 1995). Points closer than 1e-5 of the surface's
/// diagonal count as one; narrower gaps stay.
std::vector<std::array<int, 3>> hole_triangles(const PieceSurface& surface);

/// Adds such triangles as polygons opened by cracks.
void fill_holes(PieceSurface& surface, const std::vector<std::array<int, 3>>& triangles);

}  // namespace griffith::app
