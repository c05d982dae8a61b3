#include "sim/world/explicit/explicit_run.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/mesh/topology.h"
#include "sim/world/bodies/bodies.h"
#include "sim/world/bodies/bonded_pieces.h"
#include "sim/world/bodies/effective_law.h"
#include "sim/world/bodies/expected_impacts.h"
#include "sim/world/bodies/impact_speeds.h"
#include "sim/world/contact/contact_phase.h"
#include "sim/world/energy/energy_phase.h"
#include "sim/world/explicit/body_frequency.h"
#include "sim/world/explicit/similarity.h"
#include "sim/world/motion/elastic_phase.h"
#include "sim/world/output/publish.h"
#include "sim/world/state/corners.h"
#include "sim/world/state/world_state.h"

namespace griffith {
namespace {

/// Interval between checks of overload, in the time in which a wave crosses an element.
constexpr double kCheckInterval = 0.375;
/// Largest delay of a check after it is due, in microsteps.
constexpr double kLateCheck = 0.2;

}  // namespace

ExplicitRun::ExplicitRun(WorldState& world, std::vector<explicit_dynamics::Obstacle> obstacles, double ahead, int group)
    : world_(world), group_(group), start_(world.time), others_at_(world.time + ahead), time_(world.time) {
  opened_.first_event = world.crack_events.size();
  build(std::move(obstacles));
}

void ExplicitRun::build(std::vector<explicit_dynamics::Obstacle> obstacles) {
  explicit_bodies_ = {};
  bodies_.clear(), turns_.clear(), nodes_.clear(), tets_.clear(), surfaces_.clear(), overloaded_.clear();
  starts_.clear(), edges_.clear(), edge_starts_.clear();
  local_of_edge_.assign(world_.edges.offsets.size(), -1);
  local_of_node_.assign(world_.nodes.positions.size(), -1);
  slot_of_tet_.assign(world_.mesh->tets.size(), -1);
  const ExternalForces external = steady_forces();
  double size = 0;
  min_speed_ = std::numeric_limits<double>::infinity();
  for (Body& body : world_.bodies) {
    if (!is_followed(body)) continue;
    if (rebuild_) limit_frequency(world_, body);  // cuts have made other elements
    add_body(body, external);
    size += body.element_size;
    const double speed = std::min(damage_speed(world_, body), rebound_speed(world_, body));
    min_speed_ = std::min(min_speed_, std::max(speed, min_impact_speed(world_)));
  }
  size /= static_cast<double>(bodies_.size());
  explicit_bodies_.finish();
  seen_.assign(tets_.size(), -1);
  for (int i = 0; i < explicit_bodies_.node_count(); ++i) update_threshold(i);
  add_changing_loads();
  int relieved = 0;
  for (int i = 0; i < explicit_bodies_.body_count(); ++i) relieved += explicit_bodies_.body(i).relieved;
  world_.report.relieved_tets = std::max(world_.report.relieved_tets, relieved);
  contacts_.emplace(explicit_bodies_, surface_of_bodies(), crack_sides(world_, tets_, group_ != 0),
                    std::move(obstacles), surfaces_, size);
  cracks_by_face_ = restore_bonds(world_, slot_of_tet_, explicit_bodies_, *contacts_);
}

void ExplicitRun::add_body(const Body& body, const ExternalForces& external) {
  const std::vector<NodeId> nodes = nodes_of(world_.mesh, body.tets);
  const Placement placement = placement_of(world_, nodes);
  const double f = body.explicit_state->similarity;
  add_nodes(nodes, placement, f, external.nodes,
            f < 1 ? common_acceleration(body, nodes, external.nodes, true) : RigidAcceleration());
  add_edges(body, external);
  add_elements(body, placement.turn);
  bodies_.push_back(body.id);
  turns_.push_back(placement.turn);
  surfaces_.push_back({group_ == 0 ? body.scene_body : body.id.index(), world_.material_of(body).friction});
}

/// Adds nodes with `external` forces (per node of the mesh [N]). What strains the body, beyond its acceleration as a
/// whole, is scaled by f.
void ExplicitRun::add_nodes(const std::vector<NodeId>& nodes, const Placement& placement, double f,
                            const std::vector<Vec3>& external, const RigidAcceleration& as_a_whole) {
  for (const NodeId node : nodes) {
    const Vec3 reference = placement.to_world(world_.mesh->rest_positions[node]);
    const double mass = world_.nodes.masses[node];
    const Vec3 whole = external[node] / mass, common = as_a_whole.at(world_.nodes.positions[node]),
               acting = f == 1 ? whole : Vec3(common + f * (whole - common));
    local_of_node_[node] = explicit_bodies_.add_node(
        {reference, world_.nodes.positions[node] - reference, world_.nodes.velocities[node], acting, mass});
    nodes_.push_back(node);
    starts_.push_back({world_.nodes.positions[node], {whole, acting}});
    if (!world_.nodes.constraints[node].is_free())
      explicit_bodies_.constrain(local_of_node_[node], world_.nodes.constraints[node]);
  }
}

void ExplicitRun::add_edges(const Body& body, const ExternalForces& external) {
  for (const EdgeId edge : edges_of(world_.tet_edges, body.tets)) {
    const auto& [a, b] = world_.tet_edges->ends[edge];
    const NodeConstraint constraint = constraint_between(world_.nodes.constraints[a], world_.nodes.constraints[b]);
    const double mass = world_.edges.masses[edge];
    const Vec3 whole = external.edges[edge] / mass, acting = body.explicit_state->similarity * whole;
    local_of_edge_[edge] = explicit_bodies_.add_edge(
        {world_.edges.offsets[edge], world_.edges.velocities[edge], mass, constraint.allowed, acting});
    edges_.push_back(edge);
    edge_starts_.push_back({world_.edges.offsets[edge], {whole, acting}});
  }
}

void ExplicitRun::add_elements(const Body& body, const Mat3& turn) {
  std::vector<std::array<int, 4>> tets;
  std::vector<RestElement> rest_elements;
  std::vector<Mat3> offsets;
  std::vector<std::array<int, 6>> edges;
  for (const TetId tet : body.tets) {
    if (world_.tet_edges->is_quadratic(tet)) {
      std::array<int, 6>& of_tet = edges.emplace_back();
      for (int i = 0; i < 6; ++i) of_tet[i] = local_of_edge_[world_.tet_edges->of_tet[tet][i]];
    }
    std::array<int, 4>& corners = tets.emplace_back();
    for (int i = 0; i < 4; ++i) corners[i] = local(world_.mesh->tets[tet][i]);
    rest_elements.push_back(
        {turn * world_.elements.rest_elements[tet].shape_gradients, world_.elements.rest_elements[tet].volume});
    offsets.push_back(turn * world_.elements.stress_free_strain(tet) * turn.transpose());
  }
  ElasticLaw law = effective_elastic_law(world_, body);  // of stress; forces are those of E′ = f² E
  law.lambda *= body.explicit_state->similarity, law.mu *= body.explicit_state->similarity;
  explicit_bodies_.add_body(law, world_.material_of(body).density, tets, rest_elements, offsets,
                            body.explicit_state->similarity * body.explicit_state->frequency, edges);
  if (!edges.empty() && !world_.elements.point_strains.empty())
    explicit_bodies_.set_corner_offsets(turned_strains(world_.elements, body.tets, turn));
  explicit_bodies_.set_strength_surface(world_.material_of(body));
  const int first = explicit_bodies_.slot(explicit_bodies_.body_count() - 1, 0);
  tets_.resize(explicit_bodies_.tet_slots());
  for (std::size_t i = 0; i < body.tets.size(); ++i) {
    tets_[first + i] = body.tets[i];
    slot_of_tet_[body.tets[i]] = first + static_cast<int>(i);
  }
}

std::vector<explicit_dynamics::SurfaceSide> ExplicitRun::surface_of_bodies() const {
  std::vector<explicit_dynamics::SurfaceSide> surface;
  for (int slot = 0; slot < static_cast<int>(tets_.size()); ++slot) {
    if (!tets_[slot].valid()) continue;
    for (int face = 0; face < 4; ++face)
      if (!world_.mesh->neighbors[tets_[slot]][face].valid()) surface.push_back({slot, face});
  }
  return surface;
}

const Body& ExplicitRun::body_of(NodeId node) const { return body_at(world_, node); }

/// Returns the length of equal stable microsteps up to `end` [s].
double ExplicitRun::stable_microstep(double end) const {
  const double steps = std::ceil((end - time_) / explicit_bodies_.stable_step(kCourant) - 1e-9);
  return (end - time_) / std::max(1.0, steps);
}

/// Returns the time between checks of overload [s]. One is made up to a part of a microstep too early.
double ExplicitRun::check_interval() const {
  double transit = std::numeric_limits<double>::infinity();
  for (const BodyId id : bodies_) transit = std::min(transit, element_transit_time(world_, world_.bodies[id]));
  return kCheckInterval * transit - (1 - kLateCheck) * dt_;
}

bool ExplicitRun::run(double duration, double max_work) {
  const double end = time_ + duration;
  const auto goes_on = [&] { return end - time_ > 1e-9 * duration && !is_quiet(); };
  double previous_dt = 0, planned_dt = 0;
  const auto shortening = [&] {
    return dt_ < planned_dt ? planned_dt * static_cast<double>(microsteps_) / (time_ - start_) : 1;
  };
  while (goes_on()) {
    rebuild_ = false;
    dt_ = stable_microstep(end);
    if (planned_dt == 0) planned_dt = dt_;
    explicit_bodies_.set_step(dt_);
    double interval = check_interval();
    for (bool is_first = true; (is_first || goes_on()) && !rebuild_; is_first = false) {
      if (is_first || a_support_stops()) move_supports();
      const bool checks = time_ + dt_ - world_.overload_check > interval;
      explicit_bodies_.compute_forces(checks);
      apply_loads({time_ - 0.5 * previous_dt, time_ + 0.5 * dt_}, is_first ? 0 : previous_dt);
      is_first ? begin_account() : account_change_of_microstep(previous_dt);
      explicit_bodies_.advance(0.5 * (1 + previous_dt / dt_), flagged_);
      previous_dt = dt_;
      time_ += dt_;
      ++microsteps_;
      contacts_->resolve(explicit_bodies_, dt_, min_speed_);
      record_impacts();
      if (checks) check_overload();
      if (!rebuild_ && goes_on() && explicit_bodies_.raise_frequencies()) {
        dt_ = stable_microstep(end);
        explicit_bodies_.change_step(dt_);
        interval = check_interval();
      }
      if (world_.watch) show_moment();
      if (work() > max_work) return account_work(shortening()), false;
    }
    contacts_->catch_up();
    if (rebuild_) explicit_bodies_.stop_viscosity();
    explicit_bodies_.compute_forces(false);
    apply_loads({time_ - 0.5 * dt_, time_}, dt_);
    if (!rebuild_) explicit_bodies_.kick(0.5);
    end_account();
    if (rebuild_) {
      world_.time = time_;
      work_ += contacts_->work();
      store_bonds(world_);
      build({contacts_->obstacles().begin(), contacts_->obstacles().end()});
    }
  }
  account_work(1);
  return true;
}

bool ExplicitRun::is_quiet() const {
  return std::ranges::all_of(bodies_,
                             [&](BodyId id) { return time_ - world_.bodies[id].explicit_state->last_event >= quiet_; });
}

double ExplicitRun::run_until_quiet(double quiet, double duration) {
  const double start = time_;
  quiet_ = quiet;
  run(duration, std::numeric_limits<double>::infinity());
  return time_ - start;
}

double ExplicitRun::work() const { return work_of_elements() + work_ + contacts_->work(); }
double ExplicitRun::work_of_elements() const {
  double linear_tets = explicit_bodies_.tet_slots();
  for (int i = 0; i < explicit_bodies_.body_count(); ++i)
    if (explicit_bodies_.is_quadratic(i))
      linear_tets += (kQuadraticWork - 1) * explicit_dynamics::kLanes * explicit_bodies_.body(i).blocks;
  return kMicrostepWork * static_cast<double>(microsteps_) * linear_tets;
}

/// Records the work, from which the length of the next substeps and their scaling follow. `shortening`: planned over
/// actual length of the microsteps.
void ExplicitRun::account_work(double shortening) {
  world_.report.microsteps += static_cast<int>(microsteps_);
  world_.scratch.microstep_work += work();
  world_.explicit_overhead = shortening * work() / work_of_elements();
}

void ExplicitRun::record_impacts() {
  for (const explicit_dynamics::MicrostepContacts::RecordedImpact& impact : contacts_->recorded_impacts()) {
    const NodeId node = nodes_[impact.node];
    Body& body = world_.bodies[body_of(node).id];
    // What presses on, or has got stuck, strikes at every microstep: no news.
    const bool is_new = time_ - world_.nodes.pushed_at[node] > kPressing * transit_time(node);
    world_.nodes.pushed_at[node] = time_;
    if (is_new) body.explicit_state->last_event = time_;
    body.explicit_state->impact_speed = std::max(body.explicit_state->impact_speed, impact.approach);
    if (!impact.impulse.isZero(0)) record_contact(impact);
  }
}

/// Records one view of all impulses of an obstacle on a node: under pressure there is one in every microstep.
void ExplicitRun::record_contact(const explicit_dynamics::MicrostepContacts::RecordedImpact& impact) {
  const NodeId node = nodes_[impact.node];
  const explicit_dynamics::Obstacle* obstacle =
      impact.obstacle >= 0 ? &contacts_->obstacles()[impact.obstacle] : nullptr;
  const ContactView contact{body_of(node).id, obstacle ? world_.body_of(obstacle->object) : BodyId(),
                            impact.place,     -impact.normal,
                            impact.impulse,   impact.depth,
                            impact.approach};
  const auto [view, is_new] = contact_views_.try_emplace({node, impact.obstacle}, world_.output.contacts.size());
  if (is_new) {
    world_.output.contacts.push_back(contact);
  } else {
    merge(world_.output.contacts[view->second], contact);
  }
}

void ExplicitRun::write_back(WorldState& world) const {
  for (int i = 0; i < explicit_bodies_.node_count(); ++i) {
    const bool sound = explicit_bodies_.position(i).allFinite() && explicit_bodies_.velocity(i).allFinite();
    world.nodes.positions[nodes_[i]] = sound ? explicit_bodies_.position(i) : explicit_bodies_.reference(i);
    world.nodes.velocities[nodes_[i]] = sound ? explicit_bodies_.velocity(i) : Vec3::Zero();
    world.report.non_finite_values += !sound;
  }
  for (int i = 0; i < explicit_bodies_.edge_count(); ++i) {
    const bool sound = explicit_bodies_.edge_offset(i).allFinite() && explicit_bodies_.edge_velocity(i).allFinite();
    world.edges.offsets[edges_[i]] = sound ? explicit_bodies_.edge_offset(i) : Vec3::Zero();
    world.edges.velocities[edges_[i]] = sound ? explicit_bodies_.edge_velocity(i) : Vec3::Zero();
  }
  for (int slot = 0; slot < static_cast<int>(tets_.size()); ++slot) {
    if (!tets_[slot].valid() || !explicit_bodies_.is_relieved(slot)) continue;
    const TetId tet = tets_[slot];
    const ElementModel model = world.material_of(world.bodies[world.elements.bodies[tet]]).element_model;
    const Corners corners = corners_of(world.mesh, tet, world.nodes.positions);
    let_sliver_yield(world, tet, element_deformation(model, world.elements.rest_elements[tet], corners).strain);
  }
}

/// Makes the strain of a relieved sliver permanent as far as it has no stress: under the full stiffness it would return
/// more energy than it received. `strain`: the total strain [-].
void ExplicitRun::let_sliver_yield(WorldState& world, TetId tet, const Mat3& strain) const {
  world.elements.plastic_strains[tet] = strain - elastic_strain(tet, strain) - world.elements.similarity_strains[tet];
}

Mat3 ExplicitRun::elastic_strain(TetId tet, const Mat3& strain) const {
  const int slot = slot_of_tet_[tet];
  const Mat3& turn = turns_[explicit_bodies_.body_of_slot(slot)];
  return turn.transpose() * explicit_bodies_.elastic_strain(slot, turn * strain * turn.transpose()) * turn;
}

/// Writes everything to `world`, which may be a copy of that of the run. `opened`: its cracks so far.
void ExplicitRun::finish(WorldState& world, Opened opened, double duration) const {
  write_back(world);
  store_bonds(world);
  for (const explicit_dynamics::ExplicitConstraint& held : explicit_bodies_.constraints())
    world.nodes.reactions[nodes_[held.node]] =
        held.impulse / (duration * body_of(nodes_[held.node]).explicit_state->similarity);
  const BondedPieces pieces(world);
  for (const BodyId id : bodies_)
    if (world.bodies[id].bonded && pieces.of(world.bodies[id]).size() > 1) opened.bodies.insert(id);
  if (!opened.bodies.empty()) part_opened(world, opened);
  for (Body& body : world.bodies) {
    if (!is_followed(body)) continue;
    if (!body.rigid) {
      const BodySnapshot before = snapshot(world, body);
      update_elements(world, body);
      world.energy.plastic += plastic_work(world, body, before);
    }
    update_motion(world, body);
    if (!body.rigid) continue;
    body.explicit_state.reset();
    body.explicit_ended = time_;
  }
}

}  // namespace griffith
