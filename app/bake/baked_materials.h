#pragma once

#include <span>
#include <string>
#include <vector>

#include "app/bake/bake.h"
#include "sim/scene/scene.h"

namespace griffith::app {

/// Natural materials of a scene's bodies and projectiles.
struct BakedMaterials {
  std::vector<BakedMaterial> all;
  std::vector<std::array<int, kLooks>> of_body;  ///< per scene body, by Look: indices into `all`
  int projectile = 0;                            ///< index into `all`
};

/// Makes the materials of outside and inside of each body, and its mortar if it has any. `stems`: from name_stems().
BakedMaterials baked_materials(const Scene& scene, std::span<const std::string> stems);

}  // namespace griffith::app
