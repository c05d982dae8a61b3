#pragma once

#include <optional>

#include "sim/scene/scene.h"

namespace griffith::app {

/// Thickness of a shape and its direction.
struct Thickness {
  Vec3 directions = Vec3::UnitZ();  ///< 1 for each axis of the shape across which its thickness is measured, else 0
  double length = 0;                ///< [m]
};

/// Returns the least dimension of a shape: the shortest edge of a box, the depth of a plate, disc or beam, the diameter
/// or length of a cylinder, the diameter of a sphere. Empty for meshes and surfaces from files.
std::optional<Thickness> thickness_of(const Shape& shape);

/// Returns the body `factor` (> 0) times as thick, with the same cells and numbering, and with the regions of its
/// supports and loads scaled. A body lying flat keeps its lower side in place, a standing wall its middle plane.
/// `gravity`: [m/s²]. Unchanged if the shape has no thickness.
BodyDescription thickened(BodyDescription body, double factor, const Vec3& gravity);

/// Returns the position in thickened(body, factor, gravity) of a point of the undeformed body (world space [m]).
Vec3 thickened_place(const BodyDescription& body, double factor, const Vec3& gravity, const Vec3& place);

}  // namespace griffith::app
