#include "sim/fracture/softened_impact.h"

#include <cmath>
#include <cstdio>

#include "sim/mesh/number_text.h"

namespace griffith {

double softening_factor(double wave_speed, double extent, double substep, double wanted_substep) {
  const auto factor = [&](double dt) { return 1 / std::hypot(1, wave_speed * dt / extent); };
  return substep > wanted_substep ? factor(substep) / factor(wanted_substep) : 1;
}

std::string reason(const SoftenedImpact& impact) {
  char text[160];
  std::snprintf(text, sizeof text, "%s tetrahedra leave %d substep%s of %.2g ms; %.2g ms would resolve the impact",
                count_text(impact.tets).c_str(), impact.substeps, impact.substeps == 1 ? "" : "s, the longest", 1e3 * impact.substep,
                1e3 * impact.wanted_substep);
  return text;
}

}  // namespace griffith
