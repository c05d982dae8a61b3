#pragma once

#include "sim/mesh/tet_mesh.h"
#include "sim/world/output/frame.h"

namespace griffith::testing {

/// Returns the area of cracks [m²]: both faces of a crack count half.
inline double crack_area(const Frame& frame) {
  double area = 0;
  for (std::size_t tet = 0; tet < frame.elements.tets.size(); ++tet)
    for (int face = 0; face < 4; ++face) {
      if (frame.elements.neighbors[tet][face].valid() || (frame.elements.first_surface[tet] >> face & 1)) continue;
      const auto corner = [&](int i) {
        return frame.nodes.rest_positions[frame.elements.tets[tet][kTetFaces[face][i]]];
      };
      area += 0.25 * (corner(1) - corner(0)).cross(corner(2) - corner(0)).norm();
    }
  return area;
}

}  // namespace griffith::testing
