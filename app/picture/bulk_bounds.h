#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "app/picture/shown_mesh.h"

namespace griffith::app {

/// Returns the bounding box of the scene's main part [m]: the pieces nearest to the median that have 95 % of the mass
/// together, and all other pieces and projectiles within half of their extent. Objects farther away are left out. Empty
/// without bodies.
Eigen::AlignedBox3f bulk_bounds(const ShownMesh& shown);

/// Returns the bounding boxes of `count` bodies of the scene, with all their pieces [m]; empty for hidden ones.
std::vector<Eigen::AlignedBox3f> body_bounds(const ShownMesh& shown, std::size_t count);

}  // namespace griffith::app
