#include <algorithm>
#include <cmath>

#include "sim/world/conditions/supports.h"
#include "sim/world/shock/shock_run.h"
#include "sim/world/world_state.h"

/// Loads and supports that change while microsteps go on.
namespace griffith {

/// The acceleration of free nodes as a whole by forces per node of the mesh [N], which strains nothing [m/s²]; zero
/// where some are held.
Vec3 ShockRun::common_acceleration(const std::vector<NodeId>& nodes, const std::vector<Vec3>& forces) const {
  if (!std::ranges::all_of(nodes, [&](NodeId node) { return world_.nodes.constraints[node].is_free(); }))
    return Vec3::Zero();
  Vec3 force = Vec3::Zero();
  double mass = 0;
  for (const NodeId node : nodes) force += forces[node], mass += world_.nodes.masses[node];
  return force / mass;
}

/// Gravity and the loads that will not change any more, per node of the mesh [N].
std::vector<Vec3> ShockRun::steady_forces() const {
  std::vector<Vec3> forces(world_.nodes.positions.size());
  for (std::size_t i = 0; i < forces.size(); ++i) forces[i] = world_.nodes.masses[i] * world_.model->scene.gravity;
  for (const PlacedLoad& placed : world_.loads)
    if (const double factor = load_factor(placed.load, time_); factor != 0 && !changes_after(placed.load, time_))
      add_load(world_, placed, factor, forces);
  return forces;
}

/// Notes what the loads that have changes ahead do to the nodes.
void ShockRun::add_courses() {
  courses_.clear();
  of_courses_ = {};
  for (const PlacedLoad& placed : world_.loads) {
    if (!changes_after(placed.load, time_)) continue;
    std::vector<Vec3> forces(world_.nodes.positions.size(), Vec3::Zero());
    add_load(world_, placed, 1, forces);
    Course& course = courses_.emplace_back(Course{placed.load, 0, {}});
    for (const BodyId id : bodies_) {
      const Body& body = world_.bodies[id];
      const double f = body.shock->similarity;
      const std::vector<NodeId> nodes = nodes_of(world_.mesh, body.tets);
      const Vec3 common = common_acceleration(nodes, forces);
      for (const NodeId node : nodes) {
        const Vec3 whole = forces[node] / world_.nodes.masses[node], acting = common + f * (whole - common);
        if (whole.isZero(0) && acting.isZero(0)) continue;
        course.nodes.push_back({local(node), {whole, acting}, solid_.position(local(node))});
      }
    }
  }
}

/// Lets a part of a node that a crack parted take its loads along.
void ShockRun::copy_loads(int node, int copy) {
  for (Course& course : courses_) {
    const auto loaded = std::ranges::find(course.nodes, node, &Loaded::node);
    if (loaded == course.nodes.end()) continue;
    const Loaded copied{copy, loaded->full, loaded->position};
    course.nodes.push_back(copied);
  }
}

/// Lets loads act as they do on average over a span, that of the next kick, `drifted` [s] after the last kick.
void ShockRun::apply_loads(const TimeSpan& span, double drifted) {
  for (Course& course : courses_) {
    const double factor = load_factor(course.load, span);
    if (factor == course.factor) continue;
    book_loads(course, factor, drifted);
    for (const Loaded& loaded : course.nodes)
      solid_.accelerate(loaded.node, (factor - course.factor) * loaded.full.acting);
    course.factor = factor;
  }
}

/// Books the work of a load since the part that acts changed last. A kick's force works over half of the way before it
/// and half of the way after it, as all forces of microsteps do (book_account()).
void ShockRun::book_loads(Course& course, double next_factor, double drifted) {
  for (Loaded& loaded : course.nodes) {
    const Vec3 position = solid_.position(loaded.node);
    const Vec3 displacement = course.factor * (position - loaded.position) +
                              0.5 * (next_factor - course.factor) * drifted * solid_.velocity(loaded.node);
    const double mass = 1 / solid_.node(loaded.node).inverse_mass;
    of_courses_.loads += mass * loaded.full.whole.dot(displacement);
    of_courses_.scaling += mass * (loaded.full.whole - loaded.full.acting).dot(displacement);
    loaded.position = position;
  }
}

/// True if one stops in the next microstep or did in the last.
bool ShockRun::a_support_stops() const {
  return std::ranges::any_of(world_.supports, [&](const PlacedSupport& placed) {
    return placed.support.stop && std::abs(*placed.support.stop - time_) < 1.5 * dt_;
  });
}

/// Sets how supports move in the next microstep.
void ShockRun::move_supports() {
  update_supports(world_, time_, dt_);
  for (const shock::SolidConstraint& held : solid_.constraints())
    solid_.constrain(held.node, world_.nodes.constraints[nodes_[held.node]]);
}

}  // namespace griffith
