#pragma once

#include "sim/scene/scene.h"

namespace griffith {

/// Throws an InputError where quadratic elements are asked for with what they cannot do.
void check_elements(const Scene& scene, int scene_body, const Material& material);

}  // namespace griffith
