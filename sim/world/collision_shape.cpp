#include <algorithm>

#include "sim/contact/convex_pieces.h"
#include "sim/world/phases.h"

namespace griffith {
namespace {

/// Few tets or splinters make debris, whose exact shape is seen less than it costs.
constexpr std::size_t kSmallPiece = 20;
constexpr double kSmallPieceFill = 0.5, kFill = 0.9;

double fill_of(std::size_t pieces) { return pieces <= kSmallPiece ? kSmallPieceFill : kFill; }

std::vector<ConvexPart> tet_parts(const WorldState& world, const Body& body) {
  std::vector<Vec3> points;
  for (NodeId node : body.nodes) points.push_back(world.nodes.positions[node] - body.motion.center);
  std::vector<std::array<int, 4>> tets;
  for (TetId tet : body.tets) {
    std::array<int, 4> corners;
    for (int i = 0; i < 4; ++i)
      corners[i] = static_cast<int>(std::lower_bound(body.nodes.begin(), body.nodes.end(), world.mesh.tets[tet][i]) -
                                    body.nodes.begin());
    tets.push_back(corners);
  }
  return convex_parts(points, tets, fill_of(tets.size()));
}

/// The splinters whose owners are the body's.
std::vector<SplinterId> owned_splinters(const WorldState& world, const Body& body) {
  const SplinterSet& set = world.splinters;
  std::vector<SplinterId> owned;
  for (const TetId tet : body.tets) {
    if (static_cast<std::size_t>(tet) >= set.parts_of_tet.size()) continue;
    for (const int part : set.parts_of_tet[tet])
      if (const SplinterId splinter = set.parts[part].splinter; set.splinters[splinter].owner == tet)
        owned.push_back(splinter);
  }
  return owned;
}

Vec3 carried_position(const WorldState& world, const HullCorner& corner) {
  const SplinterCorner& place = world.splinters.corners[corner.corner];
  const TetId tet = carrier(world.splinters, world.splinter_state, corner.part);
  const Weights& weights = world.splinter_state.attached[corner.part] ? place.weights : place.owner_weights;
  Vec3 position = Vec3::Zero();
  for (int i = 0; i < 4; ++i) position += double(weights[i]) * world.nodes.positions[world.mesh.tets[tet][i]];
  return position;
}

std::vector<ConvexPart> splinter_parts(const WorldState& world, const Body& body,
                                       const std::vector<SplinterId>& splinters) {
  std::vector<Vec3> points;
  std::vector<ConvexPiece> pieces;
  for (const SplinterId splinter : splinters) {
    ConvexPiece& piece = pieces.emplace_back();
    piece.volume = world.splinters.splinters[splinter].volume;
    for (const HullCorner& corner : world.splinter_hulls[splinter]) {
      piece.corners.push_back(static_cast<int>(points.size()));
      points.push_back(carried_position(world, corner) - body.motion.center);
    }
  }
  return convex_parts(points, pieces, fill_of(pieces.size()));
}

}  // namespace

std::vector<ConvexPart> collision_parts(const WorldState& world, const Body& body) {
  constexpr std::size_t kMostSplinters = 256;
  if (world.scene.bodies[body.scene_body].collision != CollisionShape::splinters) return tet_parts(world, body);
  const std::vector<SplinterId> splinters = owned_splinters(world, body);
  const bool suit = !splinters.empty() && splinters.size() <= kMostSplinters;
  return suit ? splinter_parts(world, body, splinters) : tet_parts(world, body);
}

}  // namespace griffith
