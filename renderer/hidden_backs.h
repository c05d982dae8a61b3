#pragma once

#include <Eigen/Geometry>

#include "renderer/draw_scene.h"

namespace griffith::render {

/// Surfaces whose back faces are hidden by other faces and need not be drawn.
struct HiddenBacks {
  bool surface = false, embedded = false;
};

/// Returns them for a view from outside of all bodies. `glass`: transparent materials are drawn as such.
HiddenBacks hidden_backs(const DrawScene& scene, bool glass);

/// Returns them for an eye that may be inside a body.
HiddenBacks hidden_backs_from(const DrawScene& scene, bool glass, const Eigen::Vector3f& eye);

/// True if a point is inside the triangles, which must be closed.
bool is_inside(const Surface& surface, const Eigen::Vector3f& place);

/// True if a point is inside one of the tets that carry polygons.
bool is_inside(const EmbeddedSurface& surface, const Eigen::Vector3f& place);

}  // namespace griffith::render
