#include "sim/world/bodies/collision_shape.h"

#include <algorithm>

#include "sim/contact/convex_pieces.h"
#include "sim/mesh/topology.h"
#include "sim/splinters/carried_corner.h"
#include "sim/world/bodies/bodies.h"
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

/// Tets of a body, with corners as indices of its nodes.
struct LocalTets {
  std::vector<NodeId> nodes;
  std::vector<std::array<int, 4>> corners;

  LocalTets(const TetMesh& mesh, std::span<const TetId> tets) : nodes(nodes_of(mesh, tets)) {
    corners.reserve(tets.size());
    for (const TetId tet : tets) {
      std::array<int, 4>& of_tet = corners.emplace_back();
      for (int i = 0; i < 4; ++i)
        of_tet[i] = static_cast<int>(std::ranges::lower_bound(nodes, mesh.tets[tet][i]) - nodes.begin());
    }
  }

  std::vector<Vec3> points(std::span<const Vec3> positions) const {
    std::vector<Vec3> points;
    points.reserve(nodes.size());
    for (const NodeId node : nodes) points.push_back(positions[node]);
    return points;
  }
};

std::vector<Vec3> relative_to(std::vector<Vec3> points, const Vec3& center) {
  for (Vec3& point : points) point -= center;
  return points;
}

/// True if a body is bent so that hulls of its parts at rest would fill its hollows. What is strained far changes its
/// shape all the time, and keeps its parts.
bool is_bent(const WorldState& world, const Body& body) {
  constexpr double kFarStrained = 0.1;
  return is_bent_by(world, body, bending_tolerance(body)) && !is_strained_by(world, body, kFarStrained);
}

/// True if a body is not a piece of one that was divided.
bool is_undivided(const WorldState& world, const Body& body) {
  return std::ranges::count(world.bodies, body.scene_body, &Body::scene_body) <= 1;
}

/// Returns the convex parts of a body's tets. A bent body is divided as it is, another one as at rest, so that its
/// parts stay the same.
std::vector<ConvexPart> tet_parts(const WorldState& world, const Body& body) {
  if (!is_bent(world, body))
    return tet_parts(world.mesh, world.nodes.positions, body.tets, body.motion.center,
                     is_undivided(world, body) ? kCornersOfUndivided : kMaxPartCorners);
  const LocalTets local(world.mesh, body.tets);
  const Mat3 back = placement_of(world, body.nodes).turn.transpose();
  const std::vector<Vec3> points = relative_to(local.points(world.nodes.positions), body.motion.center);
  std::vector<Vec3> shape = points;
  for (Vec3& point : shape) point = back * point;
  return convex_parts(points, shape, local.corners);
}

}  // namespace

std::vector<ConvexPart> tet_parts(const TetMesh& mesh, std::span<const Vec3> positions, std::span<const TetId> tets,
                                  const Vec3& center, int max_corners) {
  constexpr double kFill = 0.97;
  const LocalTets local(mesh, tets);
  return convex_parts(relative_to(local.points(positions), center), local.points(mesh.rest_positions), local.corners,
                      kFill, max_corners);
}

bool is_bent_by(const WorldState& world, const Body& body, double distance) {
  if (!is_thin(body)) return false;
  const Placement placement = placement_of(world, body.nodes);
  return std::ranges::any_of(body.nodes, [&](NodeId node) {
    const Vec3 placed = placement.to_world(world.mesh->rest_positions[node]);
    return (world.nodes.positions[node] - placed).norm() > distance;
  });
}

std::vector<ConvexPart> collision_parts(const WorldState& world, const Body& body) {
  constexpr std::size_t kMaxSplinters = 256;
  if (world.model->scene.bodies[body.scene_body].collision != CollisionShape::splinters) return tet_parts(world, body);
  const std::vector<SplinterId> splinters = owned_splinters(world, body);
  const bool suit = !splinters.empty() && splinters.size() <= kMaxSplinters;
  return suit ? splinter_parts(world, body, splinters) : tet_parts(world, body);
}

}  // namespace griffith
