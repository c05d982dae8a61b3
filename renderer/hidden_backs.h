#pragma once

#include <Eigen/Geometry>

#include "renderer/draw_scene.h"

namespace griffith::render {

/// Of which surfaces the faces that look away are hidden by others, so that they need not be drawn.
struct HiddenBacks {
  bool surface = false, embedded = false;
};

/// Seen from outside of all bodies. `glass`: whether light comes through what is clear.
HiddenBacks hidden_backs(const DrawScene& scene, bool glass);

/// Seen from a place that may be within a body.
HiddenBacks hidden_backs_from(const DrawScene& scene, bool glass, const Eigen::Vector3f& eye);

/// Whether a place is within what the triangles bound. They must be closed.
bool is_inside(const Surface& surface, const Eigen::Vector3f& place);

/// Whether a place is within one of the tets that carry polygons.
bool is_inside(const EmbeddedSurface& surface, const Eigen::Vector3f& place);

}  // namespace griffith::render
