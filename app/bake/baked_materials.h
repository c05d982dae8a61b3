#pragma once

#include <span>
#include <string>
#include <vector>

#include "app/bake/bake.h"
#include "sim/scene/scene.h"

namespace griffith::app {

/// The natural looks of the scene's bodies, outside and inside of each one after the other, then that of projectiles.
/// `stems`: as name_stems() has them.
std::vector<BakedMaterial> baked_materials(const Scene& scene, std::span<const std::string> stems);

}  // namespace griffith::app
