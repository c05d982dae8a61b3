#include "sim/world/supports.h"

#include <algorithm>

#include "sim/world/world_state.h"

namespace griffith {
namespace {

/// The mean velocity of a support's nodes over a step.
Vec3 velocity_of(const Support& support, double time, double dt) {
  if (support.kind != SupportKind::prescribed) return Vec3::Zero();
  return support.stop ? Vec3(std::clamp((*support.stop - time) / dt, 0.0, 1.0) * support.velocity) : support.velocity;
}

void block(NodeConstraint& constraint, const Support& support, const Vec3& velocity) {
  if (support.kind == SupportKind::sliding) return constraint.block(support.normal, 0);
  for (int axis = 0; axis < 3; ++axis) constraint.block(Vec3::Unit(axis), velocity[axis]);
}

}  // namespace

void place_supports(WorldState& world, int scene_body, const RestBody& body) {
  const std::vector<Support>& supports = world.scene.bodies[scene_body].supports;
  for (std::size_t i = 0; i < supports.size(); ++i) {
    world.supports.push_back({supports[i], corners_at(body, nodes_in(body, supports[i].region))});
    if (!world.supports.back().corners.empty()) continue;
    world.findings.emplace_back("#/bodies/" + std::to_string(scene_body) + "/supports/" + std::to_string(i) + "/region",
                                "holds no node", "make it larger, or move it: regions are in the body's rest space");
  }
}

void update_supports(WorldState& world, double time, double dt) {
  for (const PlacedSupport& placed : world.supports)
    for (const TetCorner& corner : placed.corners) world.nodes.constraints[node_at(world.mesh.tets, corner)] = {};
  for (const PlacedSupport& placed : world.supports) {
    const Vec3 velocity = velocity_of(placed.support, time, dt);
    for (const TetCorner& corner : placed.corners) {
      const NodeId node = node_at(world.mesh.tets, corner);
      block(world.nodes.constraints[node], placed.support, velocity);
      world.nodes.held[node] = 1;
    }
  }
}

}  // namespace griffith
