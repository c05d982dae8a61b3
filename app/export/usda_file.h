#pragma once

#include <string>

#include "app/bake/bake.h"

namespace griffith::app {

/// Returns the bake as USD text: an Xform for each object, animated by time samples, with its Mesh; faces opened by
/// cracks form a GeomSubset with a material of their own. Mass, break time and bonds are custom attributes and data,
/// deformed points time samples of the mesh. Time codes are frames, 0 the first one.
std::string usda_file(const Bake& bake);

}  // namespace griffith::app
