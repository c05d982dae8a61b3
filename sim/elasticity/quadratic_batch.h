#pragma once

#include "sim/elasticity/quadratic_element.h"

namespace griffith {

/// Arguments of quadratic_states() for one element.
struct PlacedQuadratic {
  const RestElement* rest = nullptr;
  Corners corners;
  EdgeVectors offsets;
  CornerTensors stress_free;
};

/// Returns quadratic_states() of four elements without their forces, with the same bits, in about half the time.
std::array<QuadraticStates, 4> quadratic_stresses(const ElasticLaw& law, const std::array<PlacedQuadratic, 4>& elements,
                                                  const std::optional<PlasticLaw>& plastic = {});

}  // namespace griffith
