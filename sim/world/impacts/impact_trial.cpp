#include "sim/world/impacts/impact_trial.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "sim/core/rotation.h"
#include "sim/explicit/explicit_bodies.h"
#include "sim/explicit/microstep_contacts.h"
#include "sim/world/bodies/bodies.h"
#include "sim/world/bodies/expected_impacts.h"
#include "sim/world/bodies/impact_speeds.h"
#include "sim/world/bodies/supported_motion.h"
#include "sim/world/explicit/body_frequency.h"
#include "sim/world/explicit/explicit_obstacles.h"
#include "sim/world/explicit/explicit_run.h"
#include "sim/world/explicit/restored_bonds.h"
#include "sim/world/explicit/screening.h"
#include "sim/world/explicit/similarity.h"
#include "sim/world/fracture/separation_phase.h"
#include "sim/world/impacts/trial_loads.h"

namespace griffith {
namespace {

constexpr double kNotYet = -std::numeric_limits<double>::infinity();
/// Utilization that counts as overload, and its duration, in the time in which a wave crosses an element: less than
/// required for a crack in ExplicitRun, which checks at other microsteps.
constexpr double kOverload = 0.9, kTrialOverloadTime = 0.6;
/// Interval between checks, in the time in which a wave crosses an element.
constexpr double kTrialCheckInterval = 0.35;

/// Data of a node besides its motion.
struct TrialNode {
  double transit = 0;                ///< time in which a wave crosses an element there [s]
  double carried = 0;                ///< its utilization before
  double since = 0, last = kNotYet;  ///< first and last of the checks in a row that found it overloaded [s]
  double pushed = kNotYet;           ///< time of the last impulse at speed on it [s]
};

class Trial {
 public:
  Trial(const WorldState& world, const Impact& impact, const std::array<RigidState, 2>& states) : world_(world) {
    std::vector<explicit_dynamics::Obstacle> obstacles;
    for (int i = 0; i < 2; ++i)
      if (impact.deforms[i]) add_body(world.bodies[impact.bodies[i]], states[i]);
    for (int i = 0; i < 2; ++i)
      if (!impact.deforms[i]) add_obstacle(impact.objects()[i], states[i], obstacles);
    explicit_bodies_.finish();
    parts_.tets.resize(explicit_bodies_.tet_slots());
    if (!parts_.edges.empty()) parts_.edges.resize(explicit_bodies_.tet_slots());
    contacts_.emplace(explicit_bodies_, surface_, crack_sides(world, parts_.tets, true), std::move(obstacles), laws_,
                      spacing());
    min_speed_ = std::max(min_speed_, min_impact_speed(world));
    add_bonds();
  }

  /// Follows the impact; ends if they do not touch within `wait` [s].
  TrialOutcome run(double wait) {
    TrialOutcome outcome;
    outcome.touched = approach(wait);
    outcome.contact = time_;
    outcome.harmful = outcome.touched && follow();
    outcome.work = kMicrostepWork * microsteps_ * weight_ + contacts_->work();
    return outcome;
  }

 private:
  void add_body(const Body& body, const RigidState& state);
  std::vector<int> add_nodes(const Body& body, const RigidState& state);
  void add_elements(const Body& body, const std::vector<int>& local, const Mat3& turn);
  std::vector<std::array<int, 6>> add_edges(const Body& body);
  void add_surface(const Body& body);
  void add_obstacle(ProxyId object, const RigidState& state, std::vector<explicit_dynamics::Obstacle>& obstacles);
  void add_bonds();
  double spacing() const { return element_size_ / static_cast<double>(laws_.size()); }
  bool approach(double wait);
  bool follow();
  bool check();
  bool is_overloaded(int node);
  bool note_impacts();

  const WorldState& world_;
  explicit_dynamics::ExplicitBodies explicit_bodies_;
  TrialParts parts_;
  std::optional<explicit_dynamics::MicrostepContacts> contacts_;
  std::optional<TrialLoads> loads_;
  std::vector<TrialNode> nodes_;  ///< per explicit node
  std::vector<explicit_dynamics::SurfaceSide> surface_;
  std::vector<explicit_dynamics::SurfaceLaw> laws_;
  std::vector<int> flagged_;
  double element_size_ = 0, window_ = 0, weight_ = 0, time_ = 0, last_event_ = 0, dt_ = 0;
  double last_check_ = 0, interval_ = std::numeric_limits<double>::infinity();
  double min_speed_ = std::numeric_limits<double>::infinity();
  double microsteps_ = 0;
};

void Trial::add_body(const Body& body, const RigidState& state) {
  const std::vector<int> local = add_nodes(body, state);
  add_elements(body, local, parts_.turns.back());
  add_surface(body);
  const Material& material = world_.material_of(body);
  laws_.push_back({static_cast<int>(laws_.size()), material.friction});
  element_size_ += body.element_size;
  window_ = std::max(window_, impact_window(world_, body));
  interval_ = std::min(interval_, kTrialCheckInterval * body.element_size / bar_wave_speed(material));
  weight_ += (body.edges.empty() ? 1 : kQuadraticWork) * explicit_dynamics::kLanes *
             explicit_bodies_.body(explicit_bodies_.body_count() - 1).blocks;
  min_speed_ = std::min(min_speed_, damage_speed(world_, body));
}

/// Adds the nodes of a body with this motion, in the shape that it had when it was made or turned rigid last.
std::vector<int> Trial::add_nodes(const Body& body, const RigidState& state) {
  const double wave_speed = bar_wave_speed(world_.material_of(body));
  const Mat3 turn = state.pose.rotation.toRotationMatrix();
  Vec3 rest_center = Vec3::Zero();
  for (const NodeId node : body.nodes) rest_center += world_.nodes.masses[node] * world_.mesh->rest_positions[node];
  rest_center /= body.motion.mass;
  Mat3 correlation = Mat3::Zero();
  for (std::size_t i = 0; i < body.nodes.size(); ++i)
    correlation += world_.nodes.masses[body.nodes[i]] * body.reference_arms.col(i) *
                   (world_.mesh->rest_positions[body.nodes[i]] - rest_center).transpose();
  const Mat3& from_rest = parts_.turns.emplace_back(turn * best_rotation(correlation));
  std::vector<int> local;
  for (std::size_t i = 0; i < body.nodes.size(); ++i) {
    const NodeId node = body.nodes[i];
    const Vec3 arm = turn * body.reference_arms.col(i),
               rest_arm = from_rest * (world_.mesh->rest_positions[node] - rest_center);
    const int index = local.emplace_back(explicit_bodies_.add_node({state.pose.translation + rest_arm, arm - rest_arm,
                                                                    state.velocity + state.angular_velocity.cross(arm),
                                                                    Vec3::Zero(), world_.nodes.masses[node]}));
    if (!world_.nodes.constraints[node].is_free()) explicit_bodies_.constrain(index, world_.nodes.constraints[node]);
    const double carried = std::clamp(world_.nodes.separations[node].utilization, 0.0, 1.0);
    explicit_bodies_.node(index).threshold =
        static_cast<float>(1 - carried) * screening_stress(world_, node, world_.nodes.at_crack_front[node] != 0);
    nodes_.push_back({element_size_at(world_, node) / wave_speed, carried});
    parts_.nodes.push_back(node);
  }
  return local;
}

void Trial::add_elements(const Body& body, const std::vector<int>& local, const Mat3& turn) {
  const Material& material = world_.material_of(body);
  const ElasticLaw law = elastic_law(material);
  std::vector<std::array<int, 4>> tets;
  std::vector<RestElement> rest_elements;
  std::vector<Mat3> offsets;
  for (const TetId tet : body.tets) {
    std::array<int, 4>& corners = tets.emplace_back();
    const RestElement& rest = world_.elements.rest_elements[tet];
    for (int i = 0; i < 4; ++i)
      corners[i] = local[std::ranges::lower_bound(body.nodes, world_.mesh->tets[tet][i]) - body.nodes.begin()];
    rest_elements.push_back({turn * rest.shape_gradients, rest.volume});
    offsets.push_back(turn * world_.elements.stress_free_strain(tet) * turn.transpose());
  }
  const std::vector<std::array<int, 6>> edges = add_edges(body);
  constexpr std::size_t kUnrelieved = 50;  // tets, of which no sliver is relieved
  const double limit =
      body.tets.size() < kUnrelieved ? std::numeric_limits<double>::infinity() : highest_frequency(world_, body);
  explicit_bodies_.add_body(law, material.density, tets, rest_elements, offsets, limit, edges);
  if (!edges.empty() && !world_.elements.point_strains.empty())
    explicit_bodies_.set_corner_offsets(turned_strains(world_.elements, body.tets, turn));
  explicit_bodies_.set_strength_surface(material);
  const int first = explicit_bodies_.slot(explicit_bodies_.body_count() - 1, 0);
  parts_.tets.resize(first);
  parts_.tets.insert(parts_.tets.end(), body.tets.begin(), body.tets.end());
  if (edges.empty()) return;
  parts_.edges.resize(first);
  parts_.edges.insert(parts_.edges.end(), edges.begin(), edges.end());
}

/// Adds straight edges of quadratic tets; returns those of each tet.
std::vector<std::array<int, 6>> Trial::add_edges(const Body& body) {
  std::vector<std::array<int, 6>> edges;
  if (body.edges.empty()) return edges;
  std::vector<int> indices;
  for (const EdgeId edge : body.edges) {
    const auto& [a, b] = world_.tet_edges->ends[edge];
    const NodeConstraint held = constraint_between(world_.nodes.constraints[a], world_.nodes.constraints[b]);
    indices.push_back(explicit_bodies_.add_edge({Vec3::Zero(), Vec3::Zero(), world_.edges.masses[edge], held.allowed}));
  }
  for (const TetId tet : body.tets) {
    std::array<int, 6>& of_tet = edges.emplace_back();
    for (int i = 0; i < 6; ++i)
      of_tet[i] = indices[std::ranges::lower_bound(body.edges, world_.tet_edges->of_tet[tet][i]) - body.edges.begin()];
  }
  return edges;
}

void Trial::add_surface(const Body& body) {
  const int first = explicit_bodies_.slot(explicit_bodies_.body_count() - 1, 0);
  for (const SurfaceFace& side : body.surface) {
    const auto tet = std::ranges::lower_bound(body.tets, side.tet) - body.tets.begin();
    surface_.push_back({first + static_cast<int>(tet), side.face});
  }
}

void Trial::add_obstacle(ProxyId object, const RigidState& state, std::vector<explicit_dynamics::Obstacle>& obstacles) {
  if (world_.contact_world.is_ground(object)) return add_ground(world_, obstacles);
  if (const BodyId id = world_.body_of(object); id.valid()) {
    obstacles.push_back(obstacle_of(world_, world_.bodies[id], state, spacing()));
    return;
  }
  for (const Projectile& projectile : world_.projectiles) {
    if (projectile.object != object) continue;
    obstacles.push_back(obstacle_of(world_, projectile, spacing()));
    obstacles.back().state = state;
  }
}

/// Bonds cracks as they are, where bonds hold any.
void Trial::add_bonds() {
  if (world_.cohesive_faces.empty() || contacts_->crack_count() == 0) return;
  std::vector<int> slot_of_tet(world_.mesh->tets.size(), -1);
  for (int slot = 0; slot < static_cast<int>(parts_.tets.size()); ++slot)
    if (parts_.tets[slot].valid()) slot_of_tet[parts_.tets[slot]] = slot;
  restore_bonds(world_, slot_of_tet, explicit_bodies_, *contacts_);
}

/// Moves the objects until they touch: nothing is deformed yet. Returns false if that takes longer than `wait` [s].
bool Trial::approach(double wait) {
  constexpr double kMicrosteps = 4;  // in one of these steps
  dt_ = explicit_bodies_.stable_step(kCourant);
  const double step = kMicrosteps * dt_;
  explicit_bodies_.set_step(step);
  for (; time_ <= wait; time_ += step, ++microsteps_) {
    explicit_bodies_.advance(0, flagged_);
    contacts_->resolve(explicit_bodies_, step, 0);
    if (!contacts_->recorded_impacts().empty()) return true;
  }
  return false;
}

/// Follows the waves until nothing has caused new ones for the duration of explicit dynamics. Returns true if a node
/// may have separated, or a crack has opened further.
bool Trial::follow() {
  constexpr double kLongest = 32;  // in such windows: endless impacts are left to the shared microsteps
  explicit_bodies_.set_step(dt_);
  const double end = time_ + kLongest * window_;
  last_event_ = last_check_ = time_;
  for (; time_ < end; ++microsteps_) {
    const bool checks = time_ + dt_ - last_check_ > interval_;
    explicit_bodies_.compute_forces(checks);
    explicit_bodies_.advance(1, flagged_);
    time_ += dt_;
    contacts_->resolve(explicit_bodies_, dt_, 0);
    if (contacts_->have_bonds_opened()) return true;
    if (checks && check()) return true;
    if (note_impacts()) last_event_ = time_;
    if (time_ - last_event_ >= window_) return false;
  }
  return true;
}

/// Checks the nodes that may be overloaded. Returns true if one has been overloaded for nearly as long as its
/// separation takes.
bool Trial::check() {
  const double last = std::exchange(last_check_, time_);
  if (flagged_.empty()) return false;
  if (!loads_) loads_.emplace(world_, explicit_bodies_, parts_);
  loads_->forget();
  bool any = false;
  for (const int index : flagged_) {
    TrialNode& node = nodes_[index];
    if (!is_overloaded(index)) continue;
    if (node.last != last) node.since = time_;
    node.last = time_;
    any |= time_ - node.since >= kTrialOverloadTime * node.transit;
  }
  return any;
}

bool Trial::is_overloaded(int index) { return loads_->utilization(index) + nodes_[index].carried > kOverload; }

/// True if something strikes a node hard that was not pressed already.
bool Trial::note_impacts() {
  bool any = false;
  for (const explicit_dynamics::MicrostepContacts::RecordedImpact& impact : contacts_->recorded_impacts()) {
    if (impact.approach <= min_speed_) continue;
    TrialNode& node = nodes_[impact.node];
    any |= time_ - node.pushed > kPressing * node.transit;
    node.pushed = time_;
  }
  return any;
}

/// Returns an upper bound of the speed of its points [m/s].
double highest_speed(const WorldState& world, BodyId id, const RigidState& state) {
  return state.velocity.norm() + (id.valid() ? world.bodies[id].extent * state.angular_velocity.norm() : 0);
}

/// Returns `state` after free flight for a time [s]; `inertia` is that about its center of mass in the world frame.
RigidState flown(RigidState state, const Mat3& inertia, double time) {
  const Vec3 spin = state.angular_velocity;
  const Mat3 turn = rotation_by(time * spin).toRotationMatrix();
  state.pose.translation += time * state.velocity;
  state.pose.rotation = (Quat(turn) * state.pose.rotation).normalized();
  state.angular_velocity = turn * (inertia.inverse() * (turn.transpose() * (inertia * spin)));
  return state;
}

}  // namespace

RigidState flown(const WorldState& world, ProxyId object, const RigidState& start, double time) {
  const BodyId id = world.body_of(object);
  if (world.contact_world.is_ground(object)) return start;
  if (!id.valid()) return flown(start, Mat3::Identity(), time);  // a ball
  const Body& body = world.bodies[id];
  return body.asleep ? start : flown(start, body.motion.inertia, time);
}

std::array<RigidState, 2> flown(const WorldState& world, const Impact& impact, const Flights& flights) {
  std::array<RigidState, 2> states;
  for (int i = 0; i < 2; ++i) {
    const ProxyId object = impact.objects()[i];
    states[i] = flown(world, object, world.contact_world.state(object), flights[i]);
  }
  return states;
}

double expected_work(const WorldState& world, const Impact& impact) {
  constexpr double kAtFrequency = 0.887, kWindows = 2, kWithContacts = 2;
  double slots = 0, frequency = 0, window = 0;
  for (int i = 0; i < 2; ++i) {
    if (!impact.deforms[i]) continue;
    const Body& body = world.bodies[impact.bodies[i]];
    const auto blocks =
        static_cast<double>((body.tets.size() + explicit_dynamics::kLanes - 1) / explicit_dynamics::kLanes);
    slots += (body.edges.empty() ? 1 : kQuadraticWork) * explicit_dynamics::kLanes * blocks;
    frequency = std::max(frequency, highest_frequency(world, body));
    window = std::max(window, impact_window(world, body));
  }
  return kWithContacts * kMicrostepWork * slots * kWindows * window * frequency / kAtFrequency;
}

TrialOutcome try_impact(const WorldState& world, const Impact& impact, const std::array<RigidState, 2>& states,
                        double longest_wait) {
  // Predictions are accurate to the motion of their fastest point within the tolerance.
  const double speed =
      highest_speed(world, impact.bodies[0], states[0]) + highest_speed(world, impact.bodies[1], states[1]);
  const double wait = 2 * impact_tolerance(world) * std::max(1.0, speed / impact.met.approach);
  return Trial(world, impact, states).run(std::max(wait, longest_wait));
}

}  // namespace griffith
