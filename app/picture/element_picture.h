#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "app/picture/shown_mesh.h"

namespace griffith::app {

/// A place on an edge of a tet: (1 − t) times corner a and t times corner b.
struct EdgePlace {
  std::int8_t a = 0, b = 0;
  float t = 0;
};

/// A triangle of a picture and what it is part of.
struct PictureTriangle {
  TetId tet;
  std::int8_t face = -1;   ///< of the tet; −1: where a slice cuts through it
  std::uint8_t edges = 0;  ///< render::TriangleFlag bits of the edges to be drawn
  std::array<EdgePlace, 3> corners;
};

/// Whether face `face` of `tet`, which has no neighbour, is shown.
using FaceFilter = std::function<bool(std::size_t tet, std::size_t face)>;

/// The faces without a neighbour that the filter lets through.
std::vector<PictureTriangle> surface_triangles(const Frame& frame, const FaceFilter& shows);
/// All faces of all tets on the visible side of the slice: an element is shown whole or not at all.
std::vector<PictureTriangle> element_triangles(const ShownMesh& shown);
/// Where the view's slice plane cuts tets, facing what is hidden.
std::vector<PictureTriangle> cap_triangles(const ShownMesh& shown);

/// Positions, ids and flags of triangles, in the same order. `shrink`: size of each tet about its middle, 1: as it is.
render::Surface surface_of(const std::vector<PictureTriangle>& triangles, const ShownMesh& shown, double shrink,
                           TetId selected);

/// The scalars of these triangles, and kPlain for those that have none.
void add_scalars(const std::vector<PictureTriangle>& triangles, const Frame& frame, const QuantityValues& values,
                 render::Surface& surface);

/// All edges of the visible tets, each once, in the colours of the scalar, or grey without.
std::vector<render::Line> wireframe(const ShownMesh& shown, const QuantityValues* values,
                                    const render::ScalarStyle& style);

}  // namespace griffith::app
