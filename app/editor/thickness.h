#pragma once

#include <optional>

#include "sim/scene/scene.h"

namespace griffith::app {

/// How thick a shape is, and where to.
struct Thickness {
  Vec3 directions = Vec3::UnitZ();  ///< 1 for each axis of the shape across which it is thick, else 0
  double length = 0;                ///< [m]
};

/// The least extent of a shape: of a box its shortest edge, of a plate, disc or beam across its plane, of a cylinder
/// its diameter or its length, of a sphere its diameter. None for meshes and surfaces from files.
std::optional<Thickness> thickness_of(const Shape& shape);

/// The body `factor` (> 0) times as thick, of as many cells, which keep their numbers, with the regions of its supports
/// and loads. The side that lies below stays where it is; without such a side (a standing wall), the middle does.
/// `gravity`: [m/s²]. The body itself where it has no thickness.
BodyDescription thickened(BodyDescription body, double factor, const Vec3& gravity);

/// Where a place of the undeformed body (world space [m]) is in thickened(body, factor, gravity).
Vec3 thickened_place(const BodyDescription& body, double factor, const Vec3& gravity, const Vec3& place);

}  // namespace griffith::app
