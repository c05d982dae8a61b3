#include "sim/fracture/scaled_impact.h"

#include <array>
#include <cmath>
#include <cstdio>

#include "sim/core/number_text.h"

namespace griffith {

std::string reason(const ScaledImpact& impact) {
  constexpr std::array kLimits = {"", "; no smaller factor is used", "; the impact is too fast for a smaller factor",
                                  "; with a smaller factor it would strain too far"};  // by ScalingLimit
  return count_text(impact.tets) + " tetrahedra would take " + count_text(std::llround(impact.microsteps)) +
         " microsteps, the budget leaves " + count_text(std::llround(impact.affordable)) +
         kLimits[static_cast<std::size_t>(impact.limit)];
}

std::string scale_text(const ScaledImpact& impact) {
  char text[48];
  std::snprintf(text, sizeof text, "E/%.3g, σ/%.3g", 1 / (impact.factor * impact.factor), 1 / impact.factor);
  return text;
}

void keep_least(std::optional<ScaledImpact>& least, const std::optional<ScaledImpact>& impact) {
  if (impact && (!least || impact->factor < least->factor)) least = impact;
}

}  // namespace griffith
