#include "ui/model/surface_hit.h"

#include "sim/geometry/triangle.h"

namespace griffith::ui {

std::optional<SurfaceHit> first_surface_hit(const Frame& frame, const Vec3& origin, const Vec3& direction) {
  std::optional<SurfaceHit> first;
  for_each_surface_face(frame, [&](std::size_t tet, const std::array<NodeId, 3>& corners) {
    const auto place = [&](int i) { return frame.nodes.positions[corners[i]]; };
    const std::optional<double> distance = triangle_hit(origin, direction, place(0), place(1), place(2));
    if (distance && (!first || *distance < first->distance)) first = SurfaceHit{*distance, tet};
  });
  return first;
}

}  // namespace griffith::ui
