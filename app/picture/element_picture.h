#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "app/picture/shown_mesh.h"

namespace griffith::app {

/// A point on an edge of a tet: (1 − t) times corner a plus t times corner b.
struct EdgePlace {
  std::int8_t a = 0, b = 0;
  float t = 0;
};

/// A triangle of a picture and the element to which it belongs.
struct PictureTriangle {
  TetId tet;
  std::int8_t face = -1;   ///< face of the tet; −1: section of a slice
  std::uint8_t edges = 0;  ///< render::TriangleFlag bits of the drawn edges
  std::array<EdgePlace, 3> corners;
};

/// True if the boundary face `face` of `tet` is shown.
using FaceFilter = std::function<bool(std::size_t tet, std::size_t face)>;

/// Returns the boundary faces that the filter accepts.
std::vector<PictureTriangle> surface_triangles(const Frame& frame, const FaceFilter& shows);
/// Returns all faces of all tets on the visible side of the slice; an element is shown completely or not.
std::vector<PictureTriangle> element_triangles(const ShownMesh& shown);
/// Returns the intersections of the view's slice plane with tets, facing the hidden side.
std::vector<PictureTriangle> cap_triangles(const ShownMesh& shown);

/// Returns positions, ids and flags of triangles in the same order. `shrink`: size of each tet relative to its own,
/// about its center.
render::Surface surface_of(const std::vector<PictureTriangle>& triangles, const ShownMesh& shown, double shrink,
                           TetId selected);

/// Returns the positions at rest of the corners of these triangles [m].
std::vector<Eigen::Vector3f> rest_corners(const std::vector<PictureTriangle>& triangles, const Frame& frame);

/// Adds the scalars of these triangles, kPlain for those without one.
void add_scalars(const std::vector<PictureTriangle>& triangles, const Frame& frame, const QuantityValues& values,
                 render::Surface& surface);

/// Gives the triangles of bodies that move as a whole their plain color. True if there are any.
bool show_rigid(const std::vector<PictureTriangle>& triangles, const Frame& frame, render::Surface& surface);

/// Returns all edges of the visible tets once, in the colors of the scalar, or gray without one.
std::vector<render::Line> wireframe(const ShownMesh& shown, const QuantityValues* values,
                                    const render::ScalarStyle& style);

}  // namespace griffith::app
