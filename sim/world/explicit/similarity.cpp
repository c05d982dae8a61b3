#include "sim/world/explicit/similarity.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "sim/explicit/element_block.h"
#include "sim/explicit/explicit_bodies.h"
#include "sim/geometry/connected_groups.h"
#include "sim/solver/pivot.h"
#include "sim/world/bodies/bodies.h"
#include "sim/world/conditions/quick_changes.h"
#include "sim/world/corners.h"
#include "sim/world/energy/energy_phase.h"
#include "sim/world/phases/elastic_phase.h"
#include "sim/world/phases/subdivision.h"
#include "sim/world/world_state.h"

namespace griffith {
namespace {

/// Waves would cross the whole body so often after the last event. Pieces of it are followed as long: cracks take about
/// that time through them.
constexpr double kTransits = 4;
/// Down to here breaking speeds stay as they are; down to the least, bodies are scaled where a step would exceed its
/// ceiling.
constexpr double kMinFactor = 1.0 / 16, kLeastFactor = 1.0 / 64;
/// Impacts and spins must be slower than this share of the slowed waves.
constexpr double kImpactFraction = 0.2;
/// The length of a microstep times the highest frequency.
constexpr double kMicrostepAtFrequency = 0.887;
/// What each substep may spend, whatever was spent before: a share of the budget.
constexpr double kMinFraction = 1.0 / 8;
/// Scaled bodies strain more: no more than this at their strength.
constexpr double kMaxStrain = 0.02;
/// Explicit dynamics that this share of the budget left can follow to its end is followed as it is.
constexpr double kUnscaledFraction = 0.5;
/// Work of a step's microsteps at most, in budgets, but not less than the least [µs]: a small budget asks for scaling,
/// not for less than that leaves. And the share of it that is too little to go on with.
constexpr double kCeiling = 20, kLeastCeiling = 5e4, kSpentFraction = 0.005;
/// Of the work left, what a substep is planned to take.
constexpr double kPlanned = 0.4;

/// The least f, and what asks for it.
struct LeastFactor {
  double factor = 0;
  ScalingLimit limit = ScalingLimit::least;
};

/// `least`: for what is slow and strains little.
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

/// Where a body is, to tell its deformation from: a free one where it fits best, one that swings about its pivot, any
/// other at its place at rest.
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

/// That of the body as it would be under the full stiffness.
Vec3 unscaled_displacement(const WorldState& world, const Body& body, const Placement& frame, NodeId node) {
  const Vec3& start = world.nodes.similarity_starts[node];
  const double f = body.explicit_state->similarity;
  const Vec3 now = displacement(world, frame, node);
  return f == 1 ? now : Vec3(start + f * (now - start));
}

/// Center and angular momentum as before a change of shape.
void keep_momentum(WorldState& world, const Body& body, const RigidMotion& before) {
  const Vec3 shift = before.center - motion_of(world, body).center;
  for (const NodeId node : body.nodes) world.nodes.positions[node] += shift;
  restore_angular_momentum(world, body, before);
}

/// What the microsteps of all bodies in explicit dynamics come to.
struct Demand {
  int tets = 0;
  double slots = 0;              ///< of elements that are computed side by side, with places that pieces leave unused;
                                 ///< quadratic ones count as many linear ones as take as long
  double microsteps = 0;         ///< of what is left of the step
  double highest_frequency = 0;  ///< as slowed now [rad/s]
  double overhead = 1;           ///< see WorldState::explicit_overhead

  double work_of_microstep() const { return overhead * kMicrostepWork * slots; }  ///< [µs]
  double work() const { return microsteps * work_of_microstep(); }                ///< [µs]
};

Demand demand_of(const WorldState& world, double left) {
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
  demand.overhead = world.explicit_overhead;
  return demand;
}

/// The next substep of a step that has `left` [s] to go, however much work it takes [s].
double unlimited_substep(const WorldState& world, double left) {
  constexpr double kShortest = 1.0 / 16;  // of a time step
  const double time_step = world.model->scene.simulation.time_step, work = demand_of(world, left).work();
  const double as_last_step = work > 0 ? left * world.last_microstep_work / work : 0;
  return std::min(left, std::max({kShortest * time_step, time_step - left, time_to_follow(world), as_last_step}));
}

/// Work of a step's microsteps at most [µs of a usual core].
double ceiling_of(const WorldState& world) {
  return std::max(kLeastCeiling, 1e3 * kCeiling * world.model->scene.simulation.step_budget);
}

double microsteps_left(const WorldState& world) {
  constexpr double kPerMillisecond = 1e4, kMost = 1e9;
  return std::min(kPerMillisecond * world.model->scene.simulation.step_budget, kMost) - world.report.microsteps;
}

/// What the user is told of a body that is not followed under its full stiffness.
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

ElasticLaw effective_elastic_law(const WorldState& world, const Body& body) {
  ElasticLaw law = elastic_law(world.material_of(body));
  if (!body.explicit_state) return law;
  law.lambda *= body.explicit_state->similarity;
  law.mu *= body.explicit_state->similarity;
  return law;
}

double highest_frequency(const WorldState& world, const Body& body) {
  const Material& material = world.material_of(body);
  std::vector<RestElement> rest_elements;
  for (const TetId tet : body.tets) rest_elements.push_back(world.elements.rest_elements[tet]);
  const ElasticLaw law = elastic_law(material);
  if (!body.edges.empty()) return explicit_dynamics::highest_quadratic_frequency(law, material.density, rest_elements);
  return highest_frequency(law, material.density, rest_elements);
}

void limit_frequency(const WorldState& world, Body& body) {
  body.explicit_state->frequency = highest_frequency(world, body);
}

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
  return kTransits * world.model->extents[body.scene_body] / slowed_wave_speed(world, body);
}

double impact_window(const WorldState& world, const Body& body) {
  return kTransits * body.extent / bar_wave_speed(world.material_of(body));
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

/// Per scene body: the least index of those in explicit dynamics that it may meet within `duration` [s], straight or
/// through others. They share one f: where waves are slowed in one of two bodies alone, its faces give way too far to
/// the other's.
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
  return contact::connected_groups(count, meetings);
}

/// What the bodies of a group ask for.
struct GroupDemand {
  LeastFactor usual;  ///< with breaking speeds as they are
  double least_factor = 0, similarity = 1;
  double highest_frequency = 0;        ///< [rad/s]
  std::optional<ScaledImpact> scaled;  ///< of the slowest

  /// The f at which no frequency exceeds `affordable` [rad/s] and nobody's waves run faster than another's by now, as
  /// far as breaking speeds stay as they are; less where frequencies would exceed `ceiling` [rad/s].
  double factor(double affordable, double ceiling) const {
    return std::max(least_factor, std::min(usual_factor(affordable), ceiling / highest_frequency));
  }
  double usual_factor(double affordable) const { return std::max(usual.factor, affordable_factor(affordable)); }
  double affordable_factor(double affordable) const { return std::min(affordable / highest_frequency, similarity); }
  /// Reason for the user. `budget`: of the whole step.
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

/// The shape that belongs to a body's stress under its full stiffness; momentum and the places of supports stay.
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

/// ε = C⁻¹ σ.
Mat3 strain_of(const ElasticLaw& law, const Mat3& stress) {
  const double fraction = law.lambda / (3 * law.lambda + 2 * law.mu);
  return (stress - fraction * stress.trace() * Mat3::Identity()) / (2 * law.mu);
}

/// The shape and stress that a body had: what of its strain the full stiffness does not explain is permanent.
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
