#include "sim/world/setup/rest_body.h"

#include "sim/scene/region.h"

namespace griffith {

std::vector<std::uint8_t> nodes_in(const RestBody& body, const Region& region) {
  return nodes_in(region, body.soup.points, body.point_of_node);
}

int soup_node(const RestBody& body, const TetCorner& corner) {
  return body.soup.tets[corner.tet.index() - body.range.first_tet.index()][corner.corner];
}

std::vector<TetCorner> corners_at(const RestBody& body, const std::vector<std::uint8_t>& marked) {
  std::vector<TetCorner> corners;
  for (std::size_t tet = 0; tet < body.soup.tets.size(); ++tet)
    for (int corner = 0; corner < 4; ++corner)
      if (marked[body.soup.tets[tet][corner]])
        corners.push_back({TetId(static_cast<std::int64_t>(tet)).shifted(body.range.first_tet), corner});
  return corners;
}

}  // namespace griffith
