#pragma once

#include <span>
#include <string>
#include <vector>

#include "app/bake/bake.h"
#include "sim/scene/scene.h"

namespace griffith::app {

/// The natural looks of a scene's bodies and projectiles.
struct BakedMaterials {
  std::vector<BakedMaterial> all;
  std::vector<std::array<int, kLooks>> of_body;  ///< per scene body, by Look: indices into `all`
  int projectile = 0;                            ///< index into `all`
};

/// Makes them: outside and inside of each body, and its mortar where it has any. `stems`: as name_stems() has them.
BakedMaterials baked_materials(const Scene& scene, std::span<const std::string> stems);

}  // namespace griffith::app
