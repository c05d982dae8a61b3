#include "sim/world/explicit/similarity.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "sim/explicit/element_block.h"
#include "sim/explicit/explicit_bodies.h"
#include "sim/geometry/disjoint_sets.h"
#include "sim/solver/pivot.h"
#include "sim/world/bodies/bodies.h"
#include "sim/world/bodies/impact_speeds.h"
#include "sim/world/bodies/supported_motion.h"
#include "sim/world/conditions/quick_changes.h"
#include "sim/world/energy/energy_phase.h"
#include "sim/world/fracture/subdivision.h"
#include "sim/world/motion/elastic_phase.h"
#include "sim/world/state/corners.h"
#include "sim/world/state/world_state.h"

namespace griffith {
namespace {

/// Factors down to which bodies are scaled: to the first at unchanged breaking speeds, to the second if a step would
/// exceed its ceiling.
constexpr double kMinFactor = 1.0 / 16, kLeastFactor = 1.0 / 64;
/// Largest speed of impacts and spins as a fraction of the slowed wave speed.
constexpr double kImpactFraction = 0.2;
/// Length of a microstep times the highest frequency.
constexpr double kMicrostepAtFrequency = 0.887;
/// Fraction of the budget that each substep may use, whatever was used before.
constexpr double kMinFraction = 1.0 / 8;
/// Largest strain of a scaled body at its strength.
constexpr double kMaxStrain = 0.02;
/// Fraction of the remaining budget within which explicit dynamics is followed to its end without scaling.
constexpr double kUnscaledFraction = 0.5;
/// Largest work of a step's microsteps in budgets, and its lower limit [µs], since a small budget requests scaling and
/// nothing else; the fraction of it that is too little to continue.
constexpr double kCeiling = 20, kLeastCeiling = 5e4, kSpentFraction = 0.005;
/// Fraction of the remaining work that a substep is planned to take.
constexpr double kPlanned = 0.4;

/// Least f, and its reason.
struct LeastFactor {
  double factor = 0;
  ScalingLimit limit = ScalingLimit::least;
};

/// Returns the least f of a body, at least `least`.
LeastFactor min_factor(const WorldState& world, const Body& body, double least) {
  const Material& material = world.material_of(body);
  // Flow has its own pace; strains without stress are of whole elements, which scaled quadratic ones would need at
  // corners.
  if (material.yield_strength || !body.edges.empty()) return {1};
  const double window = explicit_window(world, body);
  if (is_pulsed(world, body, {world.time - window, world.time + window})) return {1};
  const double speed = std::max(body.explicit_state->impact_speed, inner_speed(world, body)),
               for_speed = speed / (kImpactFraction * bar_wave_speed(material)),
               for_strain = material.tensile_strength / (kMaxStrain * material.young_modulus);
  const LeastFactor needed = for_speed > for_strain ? LeastFactor{for_speed, ScalingLimit::speed}
                                                    : LeastFactor{for_strain, ScalingLimit::strain};
  return needed.factor > least ? LeastFactor{std::min(needed.factor, 1.0), needed.limit} : LeastFactor{least};
}

/// Returns the placement from which a body's deformation is measured: that of the best fit for a free body, about its
/// pivot for one that swings, and that at rest for any other.
Placement frame_of(const WorldState& world, const Body& body) {
  if (!body.supported()) return placement_of(world, body.nodes);
  const auto pivot = pivot_of(world, body);
  if (!pivot) return {};
  Placement placement = placement_of(world, body.nodes);
  placement.rest_center += placement.turn.transpose() * (pivot->place - placement.center);
  placement.center = pivot->place;
  return placement;
}

Vec3 displacement(const WorldState& world, const Placement& frame, NodeId node) {
  return frame.turn.transpose() * (world.nodes.positions[node] - frame.to_world(world.mesh->rest_positions[node]));
}

/// Returns the displacement that a node would have under the full stiffness.
Vec3 unscaled_displacement(const WorldState& world, const Body& body, const Placement& frame, NodeId node) {
  const Vec3& start = world.nodes.similarity_starts[node];
  const double f = body.explicit_state->similarity;
  const Vec3 now = displacement(world, frame, node);
  return f == 1 ? now : Vec3(start + f * (now - start));
}

/// Restores the center and angular momentum after a change of shape.
void keep_momentum(WorldState& world, const Body& body, const RigidMotion& before) {
  const Vec3 shift = before.center - motion_of(world, body).center;
  for (const NodeId node : body.nodes) world.nodes.positions[node] += shift;
  restore_momenta(world, body, before);
}

/// Work of the microsteps of all bodies in explicit dynamics.
struct Demand {
  int tets = 0;
  double slots = 0;  ///< slots of elements that are computed side by side, including unused ones of pieces; quadratic
                     ///< ones count as many linear ones as take as long
  double microsteps = 0;         ///< microsteps in the rest of the step
  double highest_frequency = 0;  ///< highest frequency of the slowed bodies [rad/s]
  double overhead = 1;           ///< see WorldState::explicit_overhead

  double work_of_microstep() const { return overhead * kMicrostepWork * slots; }  ///< [µs]
  double work() const { return microsteps * work_of_microstep(); }                ///< [µs]
};

bool has_quadratic(const WorldState& world) {
  return std::ranges::any_of(world.bodies, [](const Body& body) { return body.explicit_state && !body.edges.empty(); });
}

Demand demand_of(const WorldState& world, double left) {
  constexpr double kUsualOverhead = 1.25;  // of checks, cracks and contacts where the thin break
  Demand demand;
  for (const Body& body : world.bodies) {
    if (!body.explicit_state) continue;
    demand.tets += static_cast<int>(body.tets.size());
    const auto slots = static_cast<double>((body.tets.size() + explicit_dynamics::kLanes - 1) /
                                           explicit_dynamics::kLanes * explicit_dynamics::kLanes);
    demand.slots += (body.edges.empty() ? 1 : kQuadraticWork) * slots;
    demand.highest_frequency =
        std::max(demand.highest_frequency, body.explicit_state->similarity * body.explicit_state->frequency);
  }
  demand.microsteps = left * demand.highest_frequency / kMicrostepAtFrequency;
  demand.overhead = std::max(world.explicit_overhead, has_quadratic(world) ? kUsualOverhead : 1);
  return demand;
}

/// Returns the length of the next substep of a step with `left` [s] to go, without a limit of its work [s]: until its
/// waves are over, but at least as much work as all earlier microsteps of this step or as those of the last one, so
/// that continuing impacts do not divide the step into many substeps.
double unlimited_substep(const WorldState& world, double left) {
  constexpr double kShortest = 1.0 / 16;  // of a time step
  const double time_step = world.model->scene.simulation.time_step, work = demand_of(world, left).work();
  const double earlier_work = std::max(world.last_microstep_work, world.scratch.microstep_work);
  const double as_before = work > 0 ? left * earlier_work / work : 0;
  return std::min(left, std::max({kShortest * time_step, time_to_follow(world), as_before}));
}

/// Returns the largest work of a step's microsteps [µs of a typical core]. Quadratic bodies cannot be scaled, so they
/// are followed as far as linear ones of as many elements.
double ceiling_of(const WorldState& world) {
  const double of_linear = std::max(kLeastCeiling, 1e3 * kCeiling * world.model->scene.simulation.step_budget);
  return (has_quadratic(world) ? kQuadraticWork : 1) * of_linear;
}

double microsteps_left(const WorldState& world) {
  constexpr double kPerMillisecond = 1e4, kMost = 1e9;
  return std::min(kPerMillisecond * world.model->scene.simulation.step_budget, kMost) - world.report.microsteps;
}

/// Returns the user's record of a body that is not followed under its full stiffness.
ScaledImpact scaled_impact(const WorldState& world, const Body& body) {
  const Material& material = world.material_of(body);
  const double f = body.explicit_state->similarity;
  ScaledImpact impact = body.scaled.value_or(ScaledImpact());
  impact.factor = f;
  impact.young_modulus = f * f * material.young_modulus;
  impact.tensile_strength = f * material.tensile_strength;
  return impact;
}

}  // namespace

double inner_speed(const WorldState& world, const Body& body) {
  double fastest = 0;
  for (const NodeId node : body.nodes)
    fastest = std::max(fastest, (world.nodes.velocities[node] - body.motion.velocity).norm());
  return fastest;
}

double slowed_wave_speed(const WorldState& world, const Body& body) {
  return body.explicit_state->similarity * bar_wave_speed(world.material_of(body));
}

double element_transit_time(const WorldState& world, const Body& body) {
  return body.element_size / slowed_wave_speed(world, body);
}

double explicit_window(const WorldState& world, const Body& body) {
  return kTransits * body.extent / slowed_wave_speed(world, body);
}

double time_to_follow(const WorldState& world) {
  double until = 0;
  for (const Body& body : world.bodies)
    if (body.explicit_state)
      until = std::max(until, body.explicit_state->last_event + explicit_window(world, body) - world.time);
  return until;
}

double work_left(const WorldState& world) { return ceiling_of(world) - world.scratch.microstep_work; }

bool is_spent(const WorldState& world) {
  return microsteps_left(world) < 1 || work_left(world) < kSpentFraction * ceiling_of(world);
}

double expected_work(const WorldState& world, double substep) { return demand_of(world, substep).work(); }

double planned_substep(const WorldState& world, double left) {
  const double substep = unlimited_substep(world, left);
  const Demand demand = demand_of(world, substep);
  return std::min({1.0, microsteps_left(world) / demand.microsteps, kPlanned * work_left(world) / demand.work()}) *
         substep;
}

namespace {

/// Returns, per scene body, the smallest index of those in explicit dynamics that it may meet within `duration` [s],
/// directly or through others. These share one f: if waves are slowed in only one of two bodies, its faces yield too
/// far to the other's.
std::vector<int> explicit_groups(const WorldState& world, double duration) {
  const int count = static_cast<int>(world.model->scene.bodies.size());
  std::vector<Eigen::AlignedBox3d> boxes(count);
  for (const Body& body : world.bodies) {
    if (!body.explicit_state) continue;
    for (const NodeId node : body.nodes) {
      boxes[body.scene_body].extend(world.nodes.positions[node]);
      boxes[body.scene_body].extend(world.nodes.positions[node] + duration * world.nodes.velocities[node]);
    }
  }
  std::vector<std::pair<int, int>> meetings;
  for (int a = 0; a < count; ++a)
    for (int b = 0; b < a; ++b)
      if (!boxes[a].isEmpty() && !boxes[b].isEmpty() && boxes[a].intersects(boxes[b])) meetings.emplace_back(a, b);
  return connected_groups(count, meetings);
}

/// Demands of the bodies of a group.
struct GroupDemand {
  LeastFactor usual;  ///< with breaking speeds as they are
  double least_factor = 0, similarity = 1;
  double highest_frequency = 0;        ///< [rad/s]
  std::optional<ScaledImpact> scaled;  ///< record of the slowest body

  /// Returns the f at which no frequency exceeds `affordable` [rad/s] and no body has faster waves than before, at
  /// unchanged breaking speeds; less if frequencies would exceed `ceiling` [rad/s].
  double factor(double affordable, double ceiling) const {
    return std::max(least_factor, std::min(usual_factor(affordable), ceiling / highest_frequency));
  }
  double usual_factor(double affordable) const { return std::max(usual.factor, affordable_factor(affordable)); }
  double affordable_factor(double affordable) const { return std::min(affordable / highest_frequency, similarity); }
  /// Returns the reason for the user. `budget`: record of the whole step.
  ScaledImpact report(double affordable, const ScaledImpact& budget) const {
    ScaledImpact impact = affordable / highest_frequency < similarity ? budget : scaled.value_or(budget);
    if (usual_factor(affordable) > affordable_factor(affordable)) impact.limit = usual.limit;
    return impact;
  }
};

std::vector<GroupDemand> group_demands(const WorldState& world, const std::vector<int>& groups) {
  std::vector<GroupDemand> demands(groups.size());
  for (const Body& body : world.bodies) {
    if (!body.explicit_state) continue;
    GroupDemand& demand = demands[groups[body.scene_body]];
    const LeastFactor usual = min_factor(world, body, kMinFactor);
    if (usual.factor > demand.usual.factor) demand.usual = usual;
    demand.least_factor = std::max(demand.least_factor, min_factor(world, body, kLeastFactor).factor);
    demand.highest_frequency = std::max(demand.highest_frequency, body.explicit_state->frequency);
    if (body.explicit_state->similarity >= demand.similarity) continue;
    demand.similarity = body.explicit_state->similarity;
    demand.scaled = body.scaled;
  }
  return demands;
}

}  // namespace

void choose_similarity(WorldState& world, double left) {
  const double budget = 1e3 * world.model->scene.simulation.step_budget;
  const double available = std::max(budget - world.scratch.microstep_work, kMinFraction * budget);
  const Demand demand = demand_of(world, left);
  const double work = demand.work(), followed = unlimited_substep(world, left) / left;
  const bool is_too_much = followed * work > kUnscaledFraction * available;
  const auto is_scaled = [](const Body& body) { return body.explicit_state && body.explicit_state->similarity < 1; };
  if (!is_too_much && std::ranges::none_of(world.bodies, is_scaled)) return;
  const double unlimited = std::numeric_limits<double>::infinity();
  const double frequency = is_too_much ? demand.highest_frequency * available / work : unlimited;
  const double ceiling =
      is_too_much ? demand.highest_frequency * kPlanned * work_left(world) / (followed * work) : unlimited;
  ScaledImpact budget_report;
  budget_report.tets = demand.tets;
  budget_report.microsteps = demand.microsteps;
  budget_report.affordable = available / demand.work_of_microstep();
  const std::vector<int> groups = explicit_groups(world, left);
  const std::vector<GroupDemand> demands = group_demands(world, groups);
  for (Body& body : world.bodies) {
    if (!body.explicit_state) continue;
    const GroupDemand& group = demands[groups[body.scene_body]];
    const double factor = group.factor(frequency, ceiling);
    if (factor < body.explicit_state->similarity) {
      body.scaled = group.report(frequency, budget_report);
      set_similarity(world, body, factor);
    }
    if (body.explicit_state->similarity < 1) body.scaled = scaled_impact(world, body);
  }
}

void set_similarity(WorldState& world, Body& body, double factor) {
  const double before = body.explicit_state->similarity;
  const ElasticLaw law = elastic_law(world.material_of(body));
  ElementArrays& elements = world.elements;
  for (const TetId tet : body.tets) {
    const ElementDeformation deformation =
        element_deformation(law.model, elements.rest_elements[tet], corners_of(world.mesh, tet, world.nodes.positions));
    const Mat3 free = deformation.strain - elements.plastic_strains[tet];
    elements.similarity_strains[tet] = free - before / factor * (free - elements.similarity_strains[tet]);
  }
  const Placement frame = frame_of(world, body);
  for (const NodeId node : body.nodes)
    world.nodes.similarity_starts[node] =
        (unscaled_displacement(world, body, frame, node) - factor * displacement(world, frame, node)) / (1 - factor);
  for (const NodeId node : body.nodes) {
    OverloadHistory& overload = world.nodes.overloads[node];
    const auto slow_down = [&](double time) { return world.time + before / factor * (time - world.time); };
    overload.since = slow_down(overload.since);
    if (overload.known_from > world.time) overload.known_from = slow_down(overload.known_from);
  }
  body.explicit_state->similarity = factor;
}

namespace {

/// Sets the shape that belongs to a body's stress under its full stiffness. Keeps momentum and the places of supports.
void restore_unscaled_shape(WorldState& world, Body& body) {
  const RigidMotion before = motion_of(world, body);
  const Placement frame = frame_of(world, body);
  for (const NodeId node : body.nodes) {
    const Vec3 place = frame.center + frame.turn * (world.mesh->rest_positions[node] - frame.rest_center +
                                                    unscaled_displacement(world, body, frame, node));
    world.nodes.positions[node] += world.nodes.constraints[node].allowed * (place - world.nodes.positions[node]);
  }
  for (const TetId tet : body.tets) world.elements.similarity_strains[tet].setZero();
  body.explicit_state->similarity = 1;
  if (!body.supported()) keep_momentum(world, body, before);
  update_elements(world, body);
}

/// Returns ε = C⁻¹ σ.
Mat3 strain_of(const ElasticLaw& law, const Mat3& stress) {
  const double fraction = law.lambda / (3 * law.lambda + 2 * law.mu);
  return (stress - fraction * stress.trace() * Mat3::Identity()) / (2 * law.mu);
}

/// Restores the shape and stress of a body: strain beyond that of the full stiffness is permanent.
void keep_shape(WorldState& world, const Body& body, const BodySnapshot& before, const std::vector<Mat3>& stresses) {
  for (std::size_t i = 0; i < body.nodes.size(); ++i) {
    world.nodes.positions[body.nodes[i]] = before.positions[i];
    world.nodes.velocities[body.nodes[i]] = before.velocities[i];
  }
  const ElasticLaw law = elastic_law(world.material_of(body));
  for (std::size_t i = 0; i < body.tets.size(); ++i) {
    const TetId tet = body.tets[i];
    const Corners corners = corners_of(world.mesh, tet, world.nodes.positions);
    const Mat3 strain = element_deformation(law.model, world.elements.rest_elements[tet], corners).strain;
    world.elements.plastic_strains[tet] = strain - strain_of(law, stresses[i]);
  }
  update_elements(world, body);
}

}  // namespace

void end_similarity(WorldState& world, Body& body) {
  if (body.explicit_state->similarity == 1) return;
  constexpr double kMaxGain = 1.05;  // of elastic energy: where supports hold on to what moves
  const RigidMotion motion = motion_of(world, body);
  const BodySnapshot before = snapshot(world, body);
  const std::vector<Mat3> stresses = stresses_of(world, body);
  const double energy = energy_of(world, body), elastic = elastic_energy(world, body);
  restore_unscaled_shape(world, body);
  if (elastic_energy(world, body) > kMaxGain * elastic) keep_shape(world, body, before, stresses);
  update_motion(world, body);
  const Vec3 displacement = body.motion.center - motion.center;
  world.energy.scaling += energy - energy_of(world, body) + motion.mass * world.model->scene.gravity.dot(displacement);
}

}  // namespace griffith
