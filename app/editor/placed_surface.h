#pragma once

#include <filesystem>

#include "sim/scene/scene.h"
#include "ui/model/surface_gap.h"

namespace griffith::app {

/// Returns the bounding box of a body in its initial placement [m]. Paths of meshes start at `folder`. Throws
/// InputError if there is no such mesh.
Eigen::AlignedBox3d placed_box(const BodyDescription& body, const std::filesystem::path& folder);
/// Returns the surface of a body. Paths of meshes start at `folder`. Throws InputError if there is no such mesh.
ui::PlacedSurface placed_surface(const BodyDescription& body, const std::filesystem::path& folder);

}  // namespace griffith::app
