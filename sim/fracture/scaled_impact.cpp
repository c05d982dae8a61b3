#include "sim/fracture/scaled_impact.h"

#include <cmath>

#include "sim/mesh/number_text.h"

namespace griffith {

std::string reason(const ScaledImpact& impact) {
  return count_text(impact.tets) + " tetrahedra would take " + count_text(std::llround(impact.microsteps)) +
         " microsteps, the budget leaves " + count_text(std::llround(impact.affordable));
}

}  // namespace griffith
