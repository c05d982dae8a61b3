#include "sim/contact/polygon.h"

#include <Eigen/Geometry>
#include <utility>

namespace griffith::contact {

void clip(Polygon& polygon, const Polygon& face, const Vec3& outward) {
  Polygon other;
  Polygon *from = &polygon, *to = &other;
  for (int side = 0; side < face.count && from->count > 0; ++side) {
    const Vec3& start = face.corners[side];
    const Vec3 across = (face.corners[(side + 1) % face.count] - start).cross(outward);
    to->count = 0;
    double here_side = across.dot(from->corners[0] - start);
    for (int i = 0; i < from->count; ++i) {
      const Vec3 &here = from->corners[i], &next = from->corners[i + 1 < from->count ? i + 1 : 0];
      const double next_side = across.dot(next - start);
      if (here_side <= 0) to->add(here);
      if ((here_side < 0 && next_side > 0) || (here_side > 0 && next_side < 0))
        to->add(here + here_side / (here_side - next_side) * (next - here));
      here_side = next_side;
    }
    std::swap(from, to);
  }
  if (from != &polygon) polygon = *from;
}

}  // namespace griffith::contact
