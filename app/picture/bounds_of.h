#pragma once

#include <Eigen/Geometry>

#include "sim/world/output/frame.h"

namespace griffith::app {

/// Returns the bounding box of all finite node positions [m]; empty if there are none.
inline Eigen::AlignedBox3d bounds_of(const Frame& frame) {
  Eigen::AlignedBox3d box;
  for (const Vec3& position : frame.nodes.positions)
    if (position.allFinite()) box.extend(position);
  return box;
}

}  // namespace griffith::app
