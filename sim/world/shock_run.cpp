#include "sim/world/shock_run.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "sim/elasticity/plasticity.h"
#include "sim/elasticity/polar_decomposition.h"
#include "sim/fracture/resistance.h"
#include "sim/mesh/topology.h"
#include "sim/world/energy_phase.h"
#include "sim/world/phases.h"

namespace griffith {
namespace {

/// Share of the stable microstep.
constexpr double kCourant = 0.9;
/// Overload is looked for at this interval, in the time that a wave takes to cross an element.
constexpr double kLookInterval = 0.75;

/// The turn from rest to now that fits best.
Mat3 rotation_of(const WorldState& world, const std::vector<NodeId>& nodes, const Vec3& center,
                 const Vec3& rest_center) {
  Mat3 correlation = Mat3::Zero();
  for (const NodeId node : nodes)
    correlation += world.nodes.masses[node] * (world.nodes.positions[node] - center) *
                   (world.mesh.rest_positions[node] - rest_center).transpose();
  return polar_rotation(correlation / correlation.norm());
}

}  // namespace

ShockRun::ShockRun(WorldState& world, std::vector<shock::Obstacle> obstacles) : world_(world), time_(world.time) {
  opened_.first_event = world.crack_events.size();
  build(std::move(obstacles));
}

void ShockRun::build(std::vector<shock::Obstacle> obstacles) {
  solid_ = {};
  bodies_.clear(), nodes_.clear(), tets_.clear(), surfaces_.clear(), overloaded_.clear();
  local_of_node_.assign(world_.nodes.positions.size(), -1);
  slot_of_tet_.assign(world_.mesh.tets.size(), -1);
  const std::vector<Vec3> external = external_forces(world_);
  double size = 0;
  least_speed_ = std::numeric_limits<double>::infinity();
  for (const Body& body : world_.bodies) {
    if (!body.shock) continue;
    add_body(body, external);
    size += body.element_size;
    least_speed_ = std::min(least_speed_, std::max(hurting_speed(world_, body), least_impact_speed(world_)));
  }
  size /= static_cast<double>(bodies_.size());
  solid_.finish();
  seen_.assign(tets_.size(), -1);
  looks_.assign(nodes_.size(), {});
  for (int i = 0; i < solid_.node_count(); ++i) update_threshold(i);
  impacts_.emplace(surface_of_bodies(), cracks_of_bodies(), std::move(obstacles), surfaces_, size);
}

void ShockRun::add_body(const Body& body, const std::vector<Vec3>& external) {
  const Material& material = world_.material_of(body);
  const std::vector<NodeId> nodes = nodes_of(world_.mesh, body.tets);
  Vec3 center = Vec3::Zero(), rest_center = Vec3::Zero();
  double mass = 0;
  for (const NodeId node : nodes) {
    mass += world_.nodes.masses[node];
    center += world_.nodes.masses[node] * world_.nodes.positions[node];
    rest_center += world_.nodes.masses[node] * world_.mesh.rest_positions[node];
  }
  center /= mass, rest_center /= mass;
  const Mat3 turn = rotation_of(world_, nodes, center, rest_center);
  for (const NodeId node : nodes) {
    const Vec3 reference = center + turn * (world_.mesh.rest_positions[node] - rest_center);
    const double node_mass = world_.nodes.masses[node];
    local_of_node_[node] = solid_.add_node({reference, world_.nodes.positions[node] - reference,
                                            world_.nodes.velocities[node], external[node] / node_mass, node_mass});
    nodes_.push_back(node);
    if (!world_.nodes.constraints[node].is_free())
      solid_.constrain(local_of_node_[node], world_.nodes.constraints[node]);
  }
  std::vector<std::array<int, 4>> tets;
  std::vector<ElementRest> rests;
  std::vector<Mat3> plastic_strains;
  for (const TetId tet : body.tets) {
    std::array<int, 4>& corners = tets.emplace_back();
    for (int i = 0; i < 4; ++i) corners[i] = local(world_.mesh.tets[tet][i]);
    rests.push_back({turn * world_.elements.rests[tet].shape_gradients, world_.elements.rests[tet].volume});
    plastic_strains.push_back(turn * world_.elements.plastic_strains[tet] * turn.transpose());
  }
  solid_.add_body(elastic_law(material), material.density, tets, rests, plastic_strains);
  const int first = solid_.slot(solid_.body_count() - 1, 0);
  tets_.resize(solid_.tet_slots());
  for (std::size_t i = 0; i < body.tets.size(); ++i) {
    tets_[first + i] = body.tets[i];
    slot_of_tet_[body.tets[i]] = first + static_cast<int>(i);
  }
  bodies_.push_back(body.id);
  surfaces_.push_back({body.scene_body, material.friction});
}

std::vector<shock::SurfaceSide> ShockRun::surface_of_bodies() const {
  std::vector<shock::SurfaceSide> surface;
  for (int slot = 0; slot < static_cast<int>(tets_.size()); ++slot) {
    if (!tets_[slot].valid()) continue;
    for (int face = 0; face < 4; ++face)
      if (!world_.mesh.neighbours[tets_[slot]][face].valid()) surface.push_back({slot, face});
  }
  return surface;
}

/// Faces that cracks opened before, paired by their places at rest.
std::vector<shock::CrackSides> ShockRun::cracks_of_bodies() const {
  const TetMesh& mesh = world_.mesh;
  std::map<std::array<double, 3>, std::pair<TetId, int>> unpaired;
  std::vector<shock::CrackSides> cracks;
  for (const TetId tet : tets_) {
    if (!tet.valid()) continue;
    for (int face = 0; face < 4; ++face) {
      if (mesh.neighbours[tet][face].valid() || world_.elements.first_surface[tet] >> face & 1) continue;
      std::array<Vec3, 3> places;
      for (int i = 0; i < 3; ++i) places[i] = mesh.rest_positions[mesh.tets[tet][kTetFaces[face][i]]];
      std::ranges::sort(places, [](const Vec3& a, const Vec3& b) {
        return std::lexicographical_compare(a.data(), a.data() + 3, b.data(), b.data() + 3);
      });
      const Vec3 sum = places[0] + 2 * places[1] + 4 * places[2];  // tells faces apart, whichever corner comes first
      const std::array<double, 3> key{sum[0], sum[1], sum[2]};
      const auto [other, is_new] = unpaired.try_emplace(key, tet, face);
      if (is_new) continue;
      const auto [partner, partner_face] = other->second;
      cracks.push_back(crack_sides(mesh, partner, partner_face, tet, slot_of_tet_[partner], slot_of_tet_[tet]));
      unpaired.erase(other);
    }
  }
  return cracks;
}

const Body& ShockRun::body_of(NodeId node) const {
  return world_.bodies[world_.elements.bodies[world_.mesh.stars[node].front()]];
}

void ShockRun::run(double duration) {
  const double end = time_ + duration;
  while (end - time_ > 1e-9 * duration) {
    rebuild_ = false;
    const int steps = std::max(1, static_cast<int>(std::ceil((end - time_) / solid_.stable_step(kCourant) - 1e-9)));
    dt_ = (end - time_) / steps;
    solid_.set_step(dt_);
    double transit = std::numeric_limits<double>::infinity();
    for (const BodyId id : bodies_) transit = std::min(transit, transit_time(world_.bodies[id]));
    begin_account();
    const int interval = std::max(1, static_cast<int>(kLookInterval * transit / dt_ + 0.2));
    for (int i = 0; i < steps && !rebuild_; ++i) {
      solid_.compute_forces();
      solid_.advance(flagged_);
      time_ += dt_;
      ++microsteps_;
      impacts_->resolve(solid_, dt_, least_speed_);
      note_blows();
      if (microsteps_ % interval == 0) look();
    }
    book_account();
    if (rebuild_) {
      write_back();
      world_.time = time_;
      build({impacts_->obstacles().begin(), impacts_->obstacles().end()});
    }
  }
  world_.report.microsteps += static_cast<int>(microsteps_);
}

double ShockRun::transit_time(const Body& body) const {
  return body.element_size / bar_wave_speed(world_.material_of(body));
}

void ShockRun::note_blows() {
  for (const shock::Impacts::Blow& blow : impacts_->blows()) {
    Body& body = world_.bodies[world_.elements.bodies[world_.mesh.stars[nodes_[blow.node]].front()]];
    body.shock->last_event = time_;
    body.last_strike = world_.step;
    const shock::Obstacle* obstacle = blow.obstacle >= 0 ? &impacts_->obstacles()[blow.obstacle] : nullptr;
    world_.contact_views.push_back(
        {body.id, obstacle ? world_.body_of(obstacle->object) : BodyId(), blow.place, -blow.normal, blow.impulse});
  }
}

void ShockRun::write_back() {
  for (int i = 0; i < solid_.node_count(); ++i) {
    world_.nodes.positions[nodes_[i]] = solid_.position(i);
    world_.nodes.velocities[nodes_[i]] = solid_.velocity(i);
  }
}

void ShockRun::finish(double duration) {
  write_back();
  for (const shock::SolidConstraint& held : solid_.constraints())
    world_.nodes.reactions[nodes_[held.node]] = held.impulse / duration;
  if (!opened_.bodies.empty()) part_opened(world_, opened_);
  for (Body& body : world_.bodies) {
    if (!body.shock) continue;
    if (!body.rigid) {
      const BodySnapshot before = snapshot(world_, body);
      update_elements(world_, body);
      world_.energy.plastic += plastic_work(world_, body, before);
    }
    update_motion(world_, body);
    if (!body.rigid) continue;
    body.shock.reset();
    body.shock_ended = time_;
  }
}

}  // namespace griffith
