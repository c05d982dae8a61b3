#include "app/picture/placed_tets.h"

#include <map>

namespace griffith::app {

PlacedTets placed_tets(const Frame& frame, int scene_body) {
  return placed_tets(frame, frame.elements.tets, scene_body);
}

PlacedTets placed_tets(const Frame& frame, std::span<const std::array<NodeId, 4>> first_tets, int scene_body) {
  PlacedTets placed;
  std::map<NodeId, int> points;
  for (const TetId tet : IdRange<TetId>(0, std::ssize(first_tets))) {
    if (frame.bodies[frame.elements.bodies[tet]].scene_body != scene_body) continue;
    std::array<int, 4>& corners = placed.soup.tets.emplace_back();
    for (int i = 0; i < 4; ++i) {
      const NodeId node = first_tets[tet][i];
      const auto [found, is_new] = points.try_emplace(node, static_cast<int>(placed.soup.points.size()));
      if (is_new) placed.soup.points.push_back(frame.nodes.rest_positions[node]);
      corners[i] = found->second;
    }
    placed.tets.push_back(tet);
  }
  return placed;
}

}  // namespace griffith::app
