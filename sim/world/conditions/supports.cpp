#include "sim/world/conditions/supports.h"

#include <algorithm>
#include <limits>
#include <map>
#include <span>

#include "sim/world/state/world_state.h"

namespace griffith {
namespace {

/// Returns the mean velocity of a support's nodes over a span from `time`, or at that moment if `dt` is 0 [s].
Vec3 velocity_of(const Support& support, double time, double dt) {
  if (support.kind != SupportKind::prescribed) return Vec3::Zero();
  const double left = support.stop ? *support.stop - time : std::numeric_limits<double>::infinity();
  const double moved = dt > 0 ? std::clamp(left / dt, 0.0, 1.0) : left > 0;
  return moved * support.velocity;
}

/// Takes the node's elements out of the supports that can tear; whether there were any.
bool release(WorldState& world, NodeId node) {
  std::size_t released = 0;
  for (PlacedSupport& placed : world.supports)
    if (placed.support.can_tear)
      released += std::erase_if(placed.corners,
                                [&](const TetCorner& corner) { return node_at(world.mesh->tets, corner) == node; });
  if (released == 0) return false;
  world.nodes.constraints[node] = {};
  world.nodes.has_support[node] = 0;
  return true;
}

/// Returns the largest number of corners of one of the elements held by supports.
long firmness(const WorldState& world, std::span<const TetId> tets) {
  long maximum = 0;
  for (const TetId tet : tets)
    maximum = std::max<long>(maximum, std::ranges::count_if(world.mesh->tets[tet], [&](NodeId corner) {
                               return world.nodes.has_support[corner] != 0;
                             }));
  return maximum;
}

/// Returns the same for the elements at a node.
long firmness(const WorldState& world, NodeId node) { return firmness(world, world.mesh->stars[node]); }

constexpr long kFace = 3;  // corners of an element

/// True if three corners belong to one element.
bool has_face(const std::vector<TetCorner>& corners) {
  std::map<TetId, long> counts;
  return std::ranges::any_of(corners, [&](const TetCorner& corner) { return ++counts[corner.tet] == kFace; });
}

void block(NodeConstraint& constraint, const Support& support, const Vec3& velocity) {
  if (support.kind == SupportKind::sliding) return constraint.block(support.normal, 0);
  for (int axis = 0; axis < 3; ++axis) constraint.block(Vec3::Unit(axis), velocity[axis]);
}

}  // namespace

void place_supports(const Scene& scene, int scene_body, const RestBody& body, std::vector<PlacedSupport>& all,
                    std::vector<InputError>& findings) {
  const std::vector<Support>& supports = scene.bodies[scene_body].supports;
  for (std::size_t i = 0; i < supports.size(); ++i) {
    PlacedSupport& placed = all.emplace_back();
    placed = {supports[i], corners_at(body, nodes_in(body, supports[i].region))};
    placed.holds_faces = has_face(placed.corners);
    if (!placed.corners.empty()) continue;
    findings.emplace_back("#/bodies/" + std::to_string(scene_body) + "/supports/" + std::to_string(i) + "/region",
                          "holds no node", "make it larger, or move it: regions are in the body's rest space");
  }
}

bool tear_off(WorldState& world, NodeId node, const Vec3& normal) {
  const NodeConstraint& constraint = world.nodes.constraints[node];
  if ((normal - constraint.allowed * normal).norm() < 0.5 || !release(world, node)) return false;
  update_supports(world, world.time, 0);
  return true;
}

bool reassign_supports(WorldState& world, std::span<const NodeCopy> copies) {
  std::map<NodeId, long> firmest;
  for (const NodeCopy& copy : copies)
    if (world.nodes.has_support[copy.original])
      firmest[copy.original] =
          std::max({firmest[copy.original], firmness(world, copy.original), firmness(world, copy.copy)});
  std::vector<NodeId> loose;
  for (const NodeCopy& copy : copies)
    for (NodeId node : {copy.original, copy.copy})
      if (world.nodes.has_support[copy.original] && firmness(world, node) < firmest[copy.original])
        loose.push_back(node);
  bool torn = false;
  for (NodeId node : loose) torn |= release(world, node);
  if (torn) update_supports(world, world.time, 0);
  return torn;
}

void release_unbonded(WorldState& world, std::span<const BodyId> pieces) {
  bool torn = false;
  for (const BodyId id : pieces) {
    if (firmness(world, world.bodies[id].tets) >= kFace) continue;
    const auto is_held = [&](const TetCorner& corner) { return world.elements.bodies[corner.tet] == id; };
    bool released = false;
    for (PlacedSupport& placed : world.supports)
      if (placed.holds_faces && placed.support.can_tear) released |= std::erase_if(placed.corners, is_held) > 0;
    if (!released) continue;
    torn = true;
    world.bodies[id].system.reset();
    for (const TetId tet : world.bodies[id].tets)
      for (const NodeId node : world.mesh->tets[tet]) {
        world.nodes.constraints[node] = {};
        world.nodes.has_support[node] = 0;
      }
  }
  if (torn) update_supports(world, world.time, 0);
}

void update_supports(WorldState& world, double time, double dt) {
  for (const PlacedSupport& placed : world.supports)
    for (const TetCorner& corner : placed.corners) world.nodes.constraints[node_at(world.mesh->tets, corner)] = {};
  for (const PlacedSupport& placed : world.supports) {
    const Vec3 velocity = velocity_of(placed.support, time, dt);
    for (const TetCorner& corner : placed.corners) {
      const NodeId node = node_at(world.mesh->tets, corner);
      block(world.nodes.constraints[node], placed.support, velocity);
      world.nodes.has_support[node] = 1;
    }
  }
}

}  // namespace griffith
