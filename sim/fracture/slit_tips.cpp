#include "sim/fracture/slit_tips.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>

#include "sim/mesh/topology.h"

namespace griffith {
namespace {

using Point = std::array<double, 3>;
using FacePoints = std::array<Point, 3>;

/// The same for all faces with these corners.
FacePoints place_of(const TetMesh& mesh, const std::array<NodeId, 3>& corners) {
  FacePoints points;
  for (int i = 0; i < 3; ++i) {
    const Vec3& position = mesh.rest_positions[corners[i]];
    points[i] = {position.x(), position.y(), position.z()};
  }
  std::sort(points.begin(), points.end());
  return points;
}

}  // namespace

std::vector<NodeId> slit_tips(const TetMesh& mesh, TetId first) {
  std::map<FacePoints, std::array<NodeId, 3>> surface;
  std::set<NodeId> tips;
  for (TetId tet = first; tet < mesh.tet_count(); ++tet.value)
    for (int face = 0; face < 4; ++face) {
      if (mesh.neighbours[tet][face].valid()) continue;
      const std::array<NodeId, 3> corners = face_nodes(mesh, tet, face);
      const auto [other, is_first] = surface.emplace(place_of(mesh, corners), corners);
      if (is_first) continue;
      for (NodeId corner : corners)
        if (std::find(other->second.begin(), other->second.end(), corner) != other->second.end()) tips.insert(corner);
    }
  return {tips.begin(), tips.end()};
}

}  // namespace griffith
