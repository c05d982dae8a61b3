#pragma once

#include "sim/scene/scene.h"

namespace griffith {

/// Where a body's rest space stands in the world at the start.
Pose pose_of(const BodyDescription& body);

}  // namespace griffith
