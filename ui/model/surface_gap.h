#pragma once

#include <array>
#include <optional>
#include <vector>

#include "sim/core/linear_algebra.h"

namespace griffith::ui {

/// Surface of a body in its initial placement.
struct PlacedSurface {
  std::vector<Vec3> points;                   ///< [m]
  std::vector<std::array<int, 3>> triangles;  ///< indices into `points`
  Eigen::AlignedBox3d box;                    ///< bounding box [m]
};

/// Returns the smallest vertical distance from `lower` up to `upper` [m], exact for their triangles; negative where
/// they overlap. Empty if neither lies above the other; sides that merely touch do not.
std::optional<double> vertical_gap(const PlacedSurface& upper, const PlacedSurface& lower);

/// Returns the same along a unit vector, from `behind` to `ahead`.
std::optional<double> gap_along(const Vec3& direction, const PlacedSurface& ahead, const PlacedSurface& behind);

/// Moves a surface by an offset [m].
void move_surface(PlacedSurface& surface, const Vec3& offset);

}  // namespace griffith::ui
