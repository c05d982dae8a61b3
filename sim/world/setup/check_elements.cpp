#include "sim/world/setup/check_elements.h"

#include <string>

#include "sim/core/error.h"

namespace griffith {

void check_elements(const Scene& scene, int scene_body, const Material& material) {
  const BodyDescription& body = scene.bodies[scene_body];
  if (body.elements != ElementOrder::quadratic) return;
  const bool moves = scene.analysis == Analysis::dynamic;
  const auto require = [&](bool allowed, const char* beside, const char* remedy) {
    if (!allowed)
      throw InputError("#/bodies/" + std::to_string(scene_body) + "/elements",
                       std::string("are quadratic, which does not go with ") + beside, remedy);
  };
  require(!body.remeshing, "remeshing", "take \"linear\", or turn remeshing off");
  require(!material.yield_strength, "a yield strength", "take \"linear\", or a brittle material");
  require(!moves || scene.simulation.integrator != Integrator::symplectic_euler, "explicit integration",
          "take \"linear\", or the integrator \"implicit\"");
}

}  // namespace griffith
