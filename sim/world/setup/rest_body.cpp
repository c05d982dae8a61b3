#include "sim/world/setup/rest_body.h"

namespace griffith {

std::vector<std::uint8_t> nodes_in(const RestBody& body, const Region& region) {
  constexpr double kTolerance = 1e-9;  // of the body's size
  Eigen::AlignedBox3d bounds;
  for (const Vec3& point : body.soup.points) bounds.extend(point);
  const double tolerance = kTolerance * bounds.diagonal().norm();
  std::vector<std::uint8_t> inside(body.soup.points.size(), 0);
  for (std::size_t node = 0; node < inside.size(); ++node)
    inside[node] = contains(region, body.soup.points[node], body.point_of_node[node], tolerance);
  return inside;
}

std::vector<TetCorner> corners_at(const RestBody& body, const std::vector<std::uint8_t>& marked) {
  std::vector<TetCorner> corners;
  for (std::size_t tet = 0; tet < body.soup.tets.size(); ++tet)
    for (int corner = 0; corner < 4; ++corner)
      if (marked[body.soup.tets[tet][corner]])
        corners.push_back({TetId(body.range.first_tet + static_cast<std::int64_t>(tet)), corner});
  return corners;
}

}  // namespace griffith
