#pragma once

#include <Eigen/Geometry>

#include "app/picture/shown_mesh.h"

namespace griffith::app {

/// The box round what most of the mass does [m]: round the pieces nearest to the middle that have 95 % of it together,
/// and everything else, projectiles too, that is no farther from them than half of their extent. What has flown farther
/// is left out. Empty without bodies.
Eigen::AlignedBox3f bulk_bounds(const ShownMesh& shown);

}  // namespace griffith::app
