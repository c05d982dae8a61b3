#pragma once

#include "sim/scene/scene.h"

namespace griffith {

/// The turn about the fixed x, then y, then z axis [degrees].
Quat rotation_of(const Vec3& degrees);
/// Where a body's rest space stands in the world at the start.
Pose pose_of(const BodyDescription& body);

}  // namespace griffith
