#include "sim/world/conditions/material_point.h"

#include <array>

#include "sim/core/error.h"
#include "sim/core/tet_edge_corners.h"
#include "sim/world/bodies/bonded_pieces.h"
#include "sim/world/regime/regime_change.h"
#include "sim/world/state/world_state.h"

namespace griffith {
namespace {

/// Returns the weights of all four corners.
std::array<double, 4> corner_weights(const Vec3& weights) {
  return {1 - weights.sum(), weights[0], weights[1], weights[2]};
}

/// Calls `node` with each corner and its weight, and `edge` with each edge of a quadratic tet and its shape function.
template <class AtNode, class AtEdge>
void for_each_share(const WorldState& world, const MaterialPoint& point, AtNode node, AtEdge edge) {
  const std::array<double, 4> weights = corner_weights(point.weights);
  for (int i = 0; i < 4; ++i) node(world.mesh->tets[point.tet][i], weights[i]);
  if (!world.tet_edges->is_quadratic(point.tet)) return;
  for (int i = 0; i < 6; ++i)
    edge(world.tet_edges->of_tet[point.tet][i], 4 * weights[kTetEdges[i][0]] * weights[kTetEdges[i][1]]);
}

/// Returns the value of a field at the point, from its values at nodes and, beyond them, at edges.
Vec3 value_at(const WorldState& world, const MaterialPoint& point, const std::vector<Vec3>& of_nodes,
              const std::vector<Vec3>& of_edges) {
  Vec3 value = Vec3::Zero();
  for_each_share(
      world, point, [&](NodeId node, double share) { value += share * of_nodes[node]; },
      [&](EdgeId edge, double share) { value += share * of_edges[edge]; });
  return value;
}

}  // namespace

MaterialPoint place_point(const WorldState& world, const std::string& input, int tet, const Vec3& weights) {
  if (world.model->scene.analysis == Analysis::static_)
    throw InputError(input, "needs a scene that moves", "set \"analysis\" to \"dynamic\", or add a load");
  if (tet < 0 || static_cast<std::size_t>(tet) >= world.mesh->tets.size())
    throw InputError(input, "is of tet " + std::to_string(tet) + ", which does not exist",
                     "use an index of Frame::elements");
  constexpr double kRounding = 1e-9;
  if (!(weights.minCoeff() >= -kRounding) || !(weights.sum() <= 1 + kRounding))
    throw InputError(input, "has weights outside the tet", "use weights from 0 to 1 whose sum is at most 1");
  MaterialPoint point{TetId(tet), weights, Vec3::Zero()};
  const std::array<double, 4> of_corners = corner_weights(weights);
  for (int i = 0; i < 4; ++i)  // edges of the undeformed body are straight
    point.rest_position += of_corners[i] * world.mesh->rest_positions[world.mesh->tets[point.tet][i]];
  return point;
}

const Body& body_at(const WorldState& world, const MaterialPoint& point) {
  return world.bodies[world.elements.bodies[point.tet]];
}

Vec3 position_of(const WorldState& world, const MaterialPoint& point) {
  return value_at(world, point, world.nodes.positions, world.edges.offsets);
}

Vec3 velocity_of(const WorldState& world, const MaterialPoint& point) {
  return value_at(world, point, world.nodes.velocities, world.edges.velocities);
}

void add_force_at(const WorldState& world, const MaterialPoint& point, const Vec3& force, ExternalForces& forces) {
  for_each_share(
      world, point, [&](NodeId node, double share) { forces.nodes[node] += share * force; },
      [&](EdgeId edge, double share) { forces.edges[edge] += share * force; });
}

void wake_at(WorldState& world, const MaterialPoint& point) {
  Body& body = world.bodies[body_at(world, point).id];
  if (body.rigid && body.supported()) return;  // frozen
  if (body.tets.size() > 1 && !is_held_by_bonds(world, body) && (body.asleep || body.rigid))
    return make_elastic(world, body);
  world.contact_world.wake_up(body.proxy);
  body.asleep = false;
}

}  // namespace griffith
