#pragma once

#include "sim/scene/scene.h"
#include "sim/world/frame.h"

namespace griffith::app {

/// The box round a body of the scene in its rest space [m]. `frame`: of the world that was made from `built`, which may
/// lack the last bodies.
Eigen::AlignedBox3d rest_box(const Scene& scene, int body, const Frame& frame, const Scene& built);

/// The end of a box that lies towards `direction`, of a fiftieth of its length there: the side along the axis that is
/// nearest to the direction.
BoxRegion end_of_box(const Eigen::AlignedBox3d& box, const Vec3& direction);

/// Holds the lower end of a body with that box.
Support new_support(const BodyDescription& body, const Eigen::AlignedBox3d& box);
/// Presses on the upper end.
Load new_load(const BodyDescription& body, const Eigen::AlignedBox3d& box);
/// Looks at the middle of a body, by a name that none of the scene has.
Probe new_probe(const Scene& scene, const BodyDescription& body, const Eigen::AlignedBox3d& box);

}  // namespace griffith::app
