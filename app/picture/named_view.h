#pragma once

#include <string>

#include "sim/scene/scene.h"
#include "sim/world/output/frame.h"

namespace griffith::app {

/// Changes a view by name: a quantity ("utilization"), a layer ("stress_axes"), an element style ("wireframe",
/// "shrunken", "surface"), "exploded", "slice" or "unlit"; several are joined by "+". Layers alone are shown with plain
/// bodies. `toward_eye`: direction of the half that a slice hides. Throws InputError for an unknown name, with all
/// known ones.
void use_named_view(ViewSettings& view, const std::string& names, const Frame& frame, const Vec3& toward_eye);

}  // namespace griffith::app
