#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <optional>

#include "sim/core/rotation.h"
#include "sim/solver/rigid_motion.h"
#include "sim/world/bodies/bodies.h"
#include "sim/world/bodies/supported_motion.h"
#include "sim/world/conditions/supports.h"
#include "sim/world/explicit/explicit_run.h"
#include "sim/world/state/world_state.h"

/// Loads and supports that change during microsteps.
namespace griffith {

/// Returns the acceleration of a body with these nodes as a whole by forces per node of the mesh [N], and by its
/// rotation if it `rotates`: that in the middle of the run, unless the body turns too far to have one direction. It is
/// zero if supports hold the body more firmly than about a pivot.
RigidAcceleration ExplicitRun::common_acceleration(const Body& body, const std::vector<NodeId>& nodes,
                                                   const std::vector<Vec3>& forces, bool rotates) const {
  constexpr double kFar = 0.5;  // [rad]
  const auto is_free = [&](NodeId node) { return world_.nodes.constraints[node].is_free(); };
  const bool all_free = std::ranges::all_of(nodes, is_free);
  // Cuts of remeshing end a run at any time: it has no known middle, and the body's nodes are out of date at first.
  const bool is_cut = world_.model->scene.bodies[body.scene_body].remeshing;
  const std::optional<Pivot> pivot = all_free || is_cut ? std::nullopt : pivot_of(world_, body);
  if (!all_free && !pivot) return {};
  const RigidMotion motion = motion_of(world_, nodes);
  const Vec3 place = pivot ? pivot->place : motion.center,
             way = 0.5 * std::max(0.0, others_at_ - time_) * motion.angular_velocity;
  const bool has_direction = !is_cut && 2 * way.norm() < kFar;
  const Mat3 turn = has_direction ? rotation_by(way).toRotationMatrix() : Mat3(Mat3::Identity());
  Vec3 force = Vec3::Zero(), torque = Vec3::Zero();
  for (const NodeId node : nodes) {
    force += forces[node];
    torque += (turn * (world_.nodes.positions[node] - place)).cross(forces[node]);
  }
  const Mat3 spin = rotates && has_direction ? cross_matrix(motion.angular_velocity) : Mat3(Mat3::Zero());
  const Mat3 inertia = turn * (motion.inertia + point_inertia(motion.mass, motion.center - place)) * turn.transpose();
  if (!pivot) return {place, force / motion.mass, (cross_matrix(inertia.inverse() * torque) + spin * spin) * turn};
  const Vec3 angular = pivot->axes * (inverse_inertia_on_axes(*pivot, inertia) * (pivot->axes.transpose() * torque));
  return {place, Vec3::Zero(), (cross_matrix(angular) + spin * spin) * turn};
}

/// Returns gravity and the loads without further changes.
ExternalForces ExplicitRun::steady_forces() const {
  ExternalForces forces = weights(world_);
  for (const PlacedLoad& placed : world_.loads)
    if (const double factor = load_factor(placed.load, time_); factor != 0 && !changes_after(placed.load, time_))
      add_load(world_, placed, factor, forces);
  return forces;
}

/// Records the effect of loads with further changes on the nodes.
void ExplicitRun::add_changing_loads() {
  changing_loads_.clear();
  work_of_changing_loads_ = {};
  for (const PlacedLoad& placed : world_.loads) {
    if (!changes_after(placed.load, time_)) continue;
    ExternalForces forces = no_forces(world_);
    add_load(world_, placed, 1, forces);
    ChangingLoad& changing = changing_loads_.emplace_back(ChangingLoad{placed.load, 0, {}, {}});
    for (const BodyId id : bodies_) add_changing_load(world_.bodies[id], forces, changing);
  }
}

void ExplicitRun::add_changing_load(const Body& body, const ExternalForces& forces, ChangingLoad& changing) const {
  const double f = body.explicit_state->similarity;
  const std::vector<NodeId> nodes = nodes_of(world_.mesh, body.tets);
  const RigidAcceleration as_a_whole = common_acceleration(body, nodes, forces.nodes, false);
  for (const NodeId node : nodes) {
    const Vec3 whole = forces.nodes[node] / world_.nodes.masses[node],
               common = as_a_whole.at(world_.nodes.positions[node]), acting = common + f * (whole - common);
    if (whole.isZero(0) && acting.isZero(0)) continue;
    changing.nodes.push_back({local(node), {whole, acting}, explicit_bodies_.position(local(node))});
  }
  for (const EdgeId edge : edges_of(world_.tet_edges, body.tets)) {
    const Vec3 whole = forces.edges[edge] / world_.edges.masses[edge];
    const int index = local_of_edge_[edge];
    if (!whole.isZero(0)) changing.edges.push_back({index, {whole, f * whole}, explicit_bodies_.edge_offset(index)});
  }
}

/// Copies the load of a node or edge that a crack split.
void ExplicitRun::copy_loaded(int index, int copy, std::vector<Loaded>& loaded) {
  const auto original = std::ranges::find(loaded, index, &Loaded::index);
  if (original == loaded.end()) return;
  const Loaded copied{copy, original->full, original->position};
  loaded.push_back(copied);
}

/// Applies the mean of the loads over a span, that of the next kick, `drifted` [s] after the last kick.
void ExplicitRun::apply_loads(const TimeSpan& span, double drifted) {
  for (ChangingLoad& changing : changing_loads_) {
    const double factor = load_factor(changing.load, span);
    if (factor == changing.factor) continue;
    account_loads(changing, factor, drifted);
    for (const Loaded& loaded : changing.nodes)
      explicit_bodies_.accelerate(loaded.index, (factor - changing.factor) * loaded.full.acting);
    for (const Loaded& loaded : changing.edges)
      explicit_bodies_.accelerate_edge(loaded.index, (factor - changing.factor) * loaded.full.acting);
    changing.factor = factor;
  }
}

/// Accounts for the work of a load since its acting part changed last. A kick's force does work over half of the
/// displacement before it and half of that after it, like all forces of microsteps (end_account()).
void ExplicitRun::account_loads(ChangingLoad& changing, double next_factor, double drifted) {
  const double further = 0.5 * (next_factor - changing.factor) * drifted;
  for (Loaded& loaded : changing.nodes)
    account_load(changing, 1 / explicit_bodies_.node(loaded.index).inverse_mass,
                 explicit_bodies_.position(loaded.index), further * explicit_bodies_.velocity(loaded.index), loaded);
  for (Loaded& loaded : changing.edges)
    account_load(changing, 1 / explicit_bodies_.edge(loaded.index).inverse_mass,
                 explicit_bodies_.edge_offset(loaded.index), further * explicit_bodies_.edge_velocity(loaded.index),
                 loaded);
}

/// Accounts for the work of a load on a node or edge that has come to a position [m], and over a further motion [m].
void ExplicitRun::account_load(const ChangingLoad& changing, double mass, const Vec3& position, const Vec3& further,
                               Loaded& loaded) {
  const Vec3 displacement = changing.factor * (position - loaded.position) + further;
  work_of_changing_loads_.loads += mass * loaded.full.whole.dot(displacement);
  work_of_changing_loads_.scaling += mass * (loaded.full.whole - loaded.full.acting).dot(displacement);
  loaded.position = position;
}

/// True if one stops in the next microstep or did in the last.
bool ExplicitRun::a_support_stops() const {
  return std::ranges::any_of(world_.supports, [&](const PlacedSupport& placed) {
    return placed.support.stop && std::abs(*placed.support.stop - time_) < 1.5 * dt_;
  });
}

/// Sets how supports move in the next microstep.
void ExplicitRun::move_supports() {
  update_supports(world_, time_, dt_);
  for (const explicit_dynamics::ExplicitConstraint& held : explicit_bodies_.constraints())
    explicit_bodies_.constrain(held.node, world_.nodes.constraints[nodes_[held.node]]);
}

}  // namespace griffith
