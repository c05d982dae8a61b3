#include "app/shared/scene_warnings.h"

#include "sim/world/setup/starting_overlaps.h"

namespace griffith::app {

std::vector<InputError> scene_warnings(const Scene& scene, const World& world) {
  std::vector<InputError> warnings = world.findings();
  std::vector<InputError> overlaps = starting_overlaps(scene, world.frame());
  warnings.insert(warnings.end(), overlaps.begin(), overlaps.end());
  return warnings;
}

}  // namespace griffith::app
