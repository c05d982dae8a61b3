#pragma once

#include "sim/elasticity/element.h"
#include "tests/random_values.h"

namespace griffith::testing {

/// Returns corners of a tet of about a meter, not too flat.
inline Corners random_corners(RandomValues& random) {
  for (;;) {
    Corners corners;
    for (int i = 0; i < 4; ++i) corners.col(i) = random.vector();
    const Mat3 edges = corners.rightCols<3>().colwise() - corners.col(0);
    if (edges.determinant() > 0.1) return corners;
  }
}

/// Returns corners moved by up to `size` along each axis [m].
inline Corners shaken(Corners corners, RandomValues& random, double size) {
  for (int i = 0; i < 4; ++i) corners.col(i) += random.vector(size);
  return corners;
}

inline ElementState elastic_state(const ElasticLaw& law, const RestElement& rest, const Corners& corners) {
  return element_state(law, element_deformation(law.model, rest, corners));
}

inline Corners elastic_forces(const ElasticLaw& law, const RestElement& rest, const Corners& corners) {
  const ElementState state = elastic_state(law, rest, corners);
  return nodal_forces(rest, state.frame, state.stress);
}

}  // namespace griffith::testing
