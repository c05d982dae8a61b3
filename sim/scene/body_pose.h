#pragma once

#include "sim/scene/scene.h"

namespace griffith {

/// Returns the rotation about the fixed x, then y, then z axis [degrees].
Quat rotation_of(const Vec3& degrees);
/// Returns the initial placement of a body's rest space in the world.
Pose pose_of(const BodyDescription& body);

}  // namespace griffith
