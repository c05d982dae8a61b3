#include "sim/fracture/slit_tips.h"

#include <array>
#include <map>
#include <set>
#include <utility>

#include "sim/mesh/topology.h"

namespace griffith {

std::vector<NodeId> slit_tips(const TetMesh& mesh) {
  // Per node and position at the end of a surface edge from it: the node there.
  std::map<std::pair<NodeId, std::array<double, 3>>, NodeId> edge_ends;
  std::set<NodeId> tips;
  for (const TetId tet : IdRange<TetId>(0, mesh.tet_count()))
    for (int face = 0; face < 4; ++face) {
      if (mesh.neighbors[tet][face].valid()) continue;
      const std::array<NodeId, 3> corners = face_nodes(mesh, tet, face);
      for (NodeId node : corners)
        for (NodeId end : corners) {
          const Vec3& place = mesh.rest_positions[end];
          const auto [known, is_new] =
              edge_ends.emplace(std::pair(node, std::array{place.x(), place.y(), place.z()}), end);
          if (known->second != end) tips.insert(node);
        }
    }
  return {tips.begin(), tips.end()};
}

}  // namespace griffith
