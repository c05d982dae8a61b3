#include "sim/world/bodies/collision_shape.h"

#include <algorithm>

#include "sim/contact/convex_pieces.h"
#include "sim/mesh/topology.h"
#include "sim/splinters/carried_corner.h"
#include "sim/world/state/world_state.h"

namespace griffith {
namespace {

/// Returns the splinters of a body.
std::vector<SplinterId> owned_splinters(const WorldState& world, const Body& body) {
  const SplinterSet& set = world.model->splinters;
  std::vector<SplinterId> owned;
  for (const TetId tet : body.tets) {
    if (static_cast<std::size_t>(tet) >= set.parts_of_tet.size()) continue;
    for (const int part : set.parts_of_tet[tet])
      if (const SplinterId splinter = set.parts[part].splinter; set.splinters[splinter].owner == tet)
        owned.push_back(splinter);
  }
  return owned;
}

/// Returns the place of a corner with the nodes at `positions` [m].
Vec3 carried_position(const WorldState& world, const HullCorner& corner, std::span<const Vec3> positions) {
  const SplinterSet& set = world.model->splinters;
  const std::vector<std::uint8_t>& attached = world.splinter_state.attached;
  const TetId tet = carrier(set.splinters, set.parts, attached, corner.part);
  return carried_position(set.corners[corner.corner], attached[corner.part], world.mesh->tets[tet], positions);
}

std::vector<ConvexPart> splinter_parts(const WorldState& world, const Body& body,
                                       const std::vector<SplinterId>& splinters) {
  std::vector<Vec3> points, rest_points;
  std::vector<ConvexPiece> pieces;
  for (const SplinterId splinter : splinters) {
    ConvexPiece& piece = pieces.emplace_back();
    piece.volume = world.model->splinters.splinters[splinter].volume;
    for (const HullCorner& corner : world.model->splinter_hulls[splinter]) {
      piece.corners.push_back(static_cast<int>(points.size()));
      points.push_back(carried_position(world, corner, world.nodes.positions) - body.motion.center);
      rest_points.push_back(carried_position(world, corner, world.mesh->rest_positions));
    }
  }
  return convex_parts(points, rest_points, pieces);
}

}  // namespace

std::vector<ConvexPart> tet_parts(const TetMesh& mesh, std::span<const Vec3> positions, std::span<const TetId> tets,
                                  const Vec3& center) {
  const std::vector<NodeId> nodes = nodes_of(mesh, tets);
  std::vector<Vec3> points, rest_points;
  points.reserve(nodes.size()), rest_points.reserve(nodes.size());
  for (NodeId node : nodes) {
    points.push_back(positions[node] - center);
    rest_points.push_back(mesh.rest_positions[node]);
  }
  std::vector<std::array<int, 4>> corners_of_tets;
  corners_of_tets.reserve(tets.size());
  for (TetId tet : tets) {
    std::array<int, 4>& corners = corners_of_tets.emplace_back();
    for (int i = 0; i < 4; ++i)
      corners[i] = static_cast<int>(std::ranges::lower_bound(nodes, mesh.tets[tet][i]) - nodes.begin());
  }
  return convex_parts(points, rest_points, corners_of_tets);
}

std::vector<ConvexPart> collision_parts(const WorldState& world, const Body& body) {
  constexpr std::size_t kMaxSplinters = 256;
  const auto parts_of_tets = [&] {
    return tet_parts(world.mesh, world.nodes.positions, body.tets, body.motion.center);
  };
  if (world.model->scene.bodies[body.scene_body].collision != CollisionShape::splinters) return parts_of_tets();
  const std::vector<SplinterId> splinters = owned_splinters(world, body);
  const bool suit = !splinters.empty() && splinters.size() <= kMaxSplinters;
  return suit ? splinter_parts(world, body, splinters) : parts_of_tets();
}

}  // namespace griffith
