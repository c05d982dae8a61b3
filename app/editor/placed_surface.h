#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <vector>

#include "sim/scene/scene.h"

namespace griffith::app {

/// Surface of a body in its initial placement.
struct PlacedSurface {
  std::vector<Vec3> points;                   ///< [m]
  std::vector<std::array<int, 3>> triangles;  ///< indices into `points`
  Eigen::AlignedBox3d box;                    ///< bounding box [m]
};

/// Returns the bounding box of a body in its initial placement [m]. Paths of meshes start at `folder`. Throws
/// InputError if there is no such mesh.
Eigen::AlignedBox3d placed_box(const BodyDescription& body, const std::filesystem::path& folder);
/// Returns the surface of a body. Paths of meshes start at `folder`. Throws InputError if there is no such mesh.
PlacedSurface placed_surface(const BodyDescription& body, const std::filesystem::path& folder);

/// Returns the smallest vertical distance from `lower` up to `upper` [m], exact for their triangles; negative where
/// they overlap. Empty if neither lies above the other; sides that merely touch do not.
std::optional<double> vertical_gap(const PlacedSurface& upper, const PlacedSurface& lower);

}  // namespace griffith::app
