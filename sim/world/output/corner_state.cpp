#include "sim/world/output/corner_state.h"

#include "sim/elasticity/element.h"

namespace griffith {

bool is_quadratic(const Frame& frame, TetId tet) {
  return !frame.elements.edges.empty() && frame.elements.edges[tet][0].valid();
}

CornerState corner_state(const Frame& frame, const TetCorner& corner) {
  if (!is_quadratic(frame, corner.tet))
    return {frame.elements.stresses[corner.tet], frame.elements.states[corner.tet].energy_density};
  const ElementState& state = frame.elements.quadratic_states[corner.tet].corners[corner.corner];
  return {cauchy_stress(state.frame, state.stress), state.energy_density};
}

}  // namespace griffith
