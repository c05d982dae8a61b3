#pragma once

#include <array>
#include <optional>

#include "sim/mesh/tet_mesh.h"
#include "sim/world/output/frame.h"

namespace griffith::ui {

/// Calls `action` with the tet and corners of each face of the frame's surface, counterclockwise seen from outside.
template <class Action>
void for_each_surface_face(const Frame& frame, Action action) {
  for (std::size_t tet = 0; tet < frame.elements.tets.size(); ++tet) {
    const std::array<NodeId, 4>& corners = frame.elements.tets[tet];
    for (std::size_t face = 0; face < 4; ++face) {
      if (frame.elements.neighbors[tet][face].valid()) continue;
      const std::array<int, 3>& of_face = kTetFaces[face];
      action(tet, std::array<NodeId, 3>{corners[of_face[0]], corners[of_face[1]], corners[of_face[2]]});
    }
  }
}

/// First intersection of a ray with the frame's surface.
struct SurfaceHit {
  double distance = 0;  ///< in lengths of the ray's direction
  std::size_t tet = 0;  ///< tet with the hit face
};
std::optional<SurfaceHit> first_surface_hit(const Frame& frame, const Vec3& origin, const Vec3& direction);

}  // namespace griffith::ui
