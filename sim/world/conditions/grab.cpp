#include "sim/world/conditions/grab.h"

#include <algorithm>
#include <numbers>

#include "sim/core/error.h"
#include "sim/core/tet_edge_corners.h"
#include "sim/world/regime/regime_change.h"
#include "sim/world/state/world_state.h"

namespace griffith {
namespace {

auto find_held(auto& loads) {
  return std::ranges::find_if(loads, [](const PlacedLoad& placed) { return placed.held.has_value(); });
}

/// Returns the weights of all four corners.
std::array<double, 4> corner_weights(const Grab& grab) {
  return {1 - grab.weights.sum(), grab.weights[0], grab.weights[1], grab.weights[2]};
}

/// Calls `node` with each corner and its weight, and `edge` with each edge of a quadratic tet and its shape function.
template <class AtNode, class AtEdge>
void for_each_share(const WorldState& world, const Grab& grab, AtNode node, AtEdge edge) {
  const TetId tet(grab.tet);
  const std::array<double, 4> weights = corner_weights(grab);
  for (int i = 0; i < 4; ++i) node(world.mesh->tets[tet][i], weights[i]);
  if (!world.tet_edges->is_quadratic(tet)) return;
  for (int i = 0; i < 6; ++i)
    edge(world.tet_edges->of_tet[tet][i], 4 * weights[kTetEdges[i][0]] * weights[kTetEdges[i][1]]);
}

/// Returns the value of a field at the point, from its values at nodes and, beyond them, at edges.
Vec3 value_at(const WorldState& world, const Grab& grab, const std::vector<Vec3>& of_nodes,
              const std::vector<Vec3>& of_edges) {
  Vec3 value = Vec3::Zero();
  for_each_share(
      world, grab, [&](NodeId node, double share) { value += share * of_nodes[node]; },
      [&](EdgeId edge, double share) { value += share * of_edges[edge]; });
  return value;
}

/// Returns the place of the point in the undeformed body, whose edges are straight [m].
Vec3 rest_position_of(const WorldState& world, const Grab& grab) {
  Vec3 position = Vec3::Zero();
  const std::array<double, 4> weights = corner_weights(grab);
  for (int i = 0; i < 4; ++i) position += weights[i] * world.mesh->rest_positions[world.mesh->tets[TetId(grab.tet)][i]];
  return position;
}

/// Wakes the piece. Loads strain pieces, so it deforms unless it is a single element.
void wake(WorldState& world, Body& body) {
  if (body.rigid && body.supported()) return;  // frozen
  if (body.tets.size() > 1 && !body.bonded && (body.asleep || body.rigid)) return make_elastic(world, body);
  world.contact_world.wake_up(body.proxy);
  body.asleep = false;
}

void check(const WorldState& world, const Grab& grab) {
  if (world.model->scene.analysis == Analysis::static_)
    throw InputError("grab", "needs a scene that moves", "set \"analysis\" to \"dynamic\", or add a load");
  if (grab.tet < 0 || static_cast<std::size_t>(grab.tet) >= world.mesh->tets.size())
    throw InputError("grab", "is of tet " + std::to_string(grab.tet) + ", which does not exist",
                     "use an index of Frame::elements");
  constexpr double kRounding = 1e-9;
  if (!(grab.weights.minCoeff() >= -kRounding) || !(grab.weights.sum() <= 1 + kRounding) || !grab.target.allFinite())
    throw InputError("grab", "has weights outside the tet, or a target that is not finite",
                     "use weights from 0 to 1 whose sum is at most 1");
}

}  // namespace

PlacedLoad* present_grab(WorldState& world) {
  const auto placed = find_held(world.loads);
  return placed == world.loads.end() ? nullptr : &*placed;
}

const Body& grabbed_body(const WorldState& world, const Grab& grab) {
  return world.bodies[world.elements.bodies[TetId(grab.tet)]];
}

Vec3 grabbed_position(const WorldState& world, const Grab& grab) {
  return value_at(world, grab, world.nodes.positions, world.edges.offsets);
}

SpringConstants spring_constants(const WorldState& world, const Grab& grab) {
  constexpr double kStandardGravity = 9.80665;  // [m/s²]
  constexpr double kMaxPhase = 0.3;             // of a period in a time step [rad]: 20 steps and more
  const double mass = grabbed_body(world, grab).motion.mass;
  const double frequency =
      std::min(2 * std::numbers::pi * grab.spring.frequency, kMaxPhase / world.model->scene.simulation.time_step);
  return {mass * frequency * frequency, 2 * grab.spring.damping_ratio * mass * frequency,
          grab.spring.strength * mass * kStandardGravity};
}

void begin_grab(WorldState& world, const Grab& grab) {
  check(world, grab);
  end_grab(world);
  wake(world, world.bodies[grabbed_body(world, grab).id]);
  PlacedLoad placed{{}, {}, {}, {}, {}};
  placed.load.kind = LoadKind::point_force;
  placed.load.force = Vec3::Zero();
  placed.load.start = world.time;
  placed.held = HeldPoint{grab, rest_position_of(world, grab), grabbed_position(world, grab),
                          value_at(world, grab, world.nodes.velocities, world.edges.velocities), world.time};
  world.loads.push_back(std::move(placed));
}

void move_grab(WorldState& world, const Vec3& target) {
  PlacedLoad* placed = present_grab(world);
  if (!placed || !target.allFinite())
    throw InputError("grab", "cannot move: nothing is grabbed, or its target is not finite", "grab a piece first");
  placed->held->grab.target = target;
}

void end_grab(WorldState& world) {
  const auto placed = find_held(world.loads);
  if (placed != world.loads.end()) world.loads.erase(placed);
}

std::optional<GrabView> grab_view(const WorldState& world) {
  const auto placed = find_held(world.loads);
  if (placed == world.loads.end()) return std::nullopt;
  const Grab& grab = placed->held->grab;
  return GrabView{grabbed_body(world, grab).id, grabbed_position(world, grab), grab.target, placed->load.force,
                  spring_constants(world, grab).max_force};
}

void add_force_at(const WorldState& world, const Grab& grab, const Vec3& force, ExternalForces& forces) {
  for_each_share(
      world, grab, [&](NodeId node, double share) { forces.nodes[node] += share * force; },
      [&](EdgeId edge, double share) { forces.edges[edge] += share * force; });
}

}  // namespace griffith
