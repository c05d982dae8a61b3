#include "sim/world/shock_run.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "sim/elasticity/plasticity.h"
#include "sim/elasticity/polar_decomposition.h"
#include "sim/fracture/resistance.h"
#include "sim/mesh/topology.h"
#include "sim/world/phases.h"

namespace griffith {
namespace {

/// Share of the stable microstep.
constexpr double kCourant = 0.9;
/// Overload is looked for at this interval, and opens a node when it has lasted so long, in the time that a wave takes
/// to cross an element.
constexpr double kLookInterval = 0.75, kOverloadTime = 0.5;
/// Cracks run no faster than this share of the bar wave's speed: some half of the Rayleigh wave's (Freund 1990).
constexpr double kCrackSpeed = 0.3;
/// Elements are screened by the stress of another frame than the nodes are judged by.
constexpr float kScreeningShare = 0.97F;

/// The turn from rest to now that fits best.
Mat3 rotation_of(const WorldState& world, const std::vector<NodeId>& nodes, const Vec3& center, const Vec3& rest_center) {
  Mat3 correlation = Mat3::Zero();
  for (const NodeId node : nodes)
    correlation += world.nodes.masses[node] * (world.nodes.positions[node] - center) *
                   (world.mesh.rest_positions[node] - rest_center).transpose();
  return polar_rotation(correlation / correlation.norm());
}

/// The cut faces of a tet that lost a neighbour, corner by corner beside what was there.
shock::CrackSides sides_of(const TetMesh& mesh, TetId first, int first_face, TetId second, int first_slot, int second_slot) {
  shock::CrackSides sides{first_slot, second_slot, {}, {}};
  for (int i = 0; i < 3; ++i) {
    sides.first_corners[i] = kTetFaces[first_face][i];
    const Vec3& place = mesh.rest_positions[mesh.tets[first][sides.first_corners[i]]];
    for (int corner = 0; corner < 4; ++corner)
      if (mesh.rest_positions[mesh.tets[second][corner]] == place) sides.second_corners[i] = corner;
  }
  return sides;
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
  const double f = body.shock->similarity;
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
  for (const TetId tet : body.tets) {
    std::array<int, 4>& corners = tets.emplace_back();
    for (int i = 0; i < 4; ++i) corners[i] = local(world_.mesh.tets[tet][i]);
    rests.push_back({turn * world_.elements.rests[tet].shape_gradients, world_.elements.rests[tet].volume});
  }
  ElasticLaw law = elastic_law(material);
  law.lambda *= f * f, law.mu *= f * f;
  solid_.add_body(law, material.density, material.stiffness_damping / f, tets, rests, {});
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
      cracks.push_back(sides_of(mesh, partner, partner_face, tet, slot_of_tet_[partner], slot_of_tet_[tet]));
      unpaired.erase(other);
    }
  }
  return cracks;
}

const Body& ShockRun::body_of(NodeId node) const {
  return world_.bodies[world_.elements.bodies[world_.mesh.stars[node].front()]];
}

double ShockRun::element_size(NodeId node) const {
  double volume = 0;
  for (const TetId tet : world_.mesh.stars[node]) volume += world_.elements.rests[tet].volume;
  return std::cbrt(6 * volume / static_cast<double>(world_.mesh.stars[node].size()));
}

/// The stress in an element at a node below which the node cannot be overloaded.
void ShockRun::update_threshold(int index) {
  const NodeId node = nodes_[index];
  const Body& body = body_of(node);
  const Material& material = world_.material_of(body);
  shock::SolidNode& target = solid_.node(index);
  target.threshold = std::numeric_limits<float>::infinity();
  if (!world_.scene.simulation.fracture) return;
  if (world_.mesh.stars[node].size() == 1 && world_.nodes.held[node] == 0) return;  // a tip: nothing to part
  double least = resistance(material, world_.nodes.at_crack_front[node] != 0, element_size(node),
                            world_.nodes.strength_factors[node]);
  if (const auto& weakness = world_.weaknesses[body.scene_body]) least *= weakness->strength_ratio;
  if (material.criterion == FractureCriterion::separation_force) {
    double area = 0;  // v⁺ is at most half the sum of the tensile forces
    for (const TetId tet : world_.mesh.stars[node])
      area += world_.elements.rests[tet].volume *
              world_.elements.rests[tet].shape_gradients.col(local_corner(world_.mesh, tet, node)).norm();
    least *= 2 / area;
  }
  target.threshold = kScreeningShare * static_cast<float>(body.shock->similarity * least);
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
    const int interval = std::max(1, static_cast<int>(kLookInterval * transit / dt_ + 0.2));
    for (int i = 0; i < steps && !rebuild_; ++i) {
      solid_.compute_forces();
      solid_.advance(flagged_);
      time_ += dt_;
      ++microsteps_;
      impacts_->resolve(solid_, dt_, least_speed_);
      note_blows();
      if (microsteps_ % interval == 0) look();
      if (getenv("DBG") && microsteps_ % atoi(getenv("DBG")) == 0) {
        double ke = 0, vmax = 0;
        for (int k = 0; k < solid_.node_count(); ++k) {
          const double e = 0.5 / solid_.node(k).inverse_mass * solid_.velocity(k).squaredNorm();
          ke += e, vmax = std::max(vmax, solid_.velocity(k).norm());
        }
        const auto obs = impacts_->obstacles();
        fprintf(stderr, "  micro %ld t %.6f KE %.4g vmax %.4g lost %.4g cracks %d obstacles %zu ball %.4g touches %zu blows %zu dt %.3g evals %ld least %.3g\n", microsteps_, time_, ke, vmax, impacts_->energy_lost(), world_.report.cracks, obs.size(), obs.empty() ? 0. : obs.back().state.velocity.norm(), impacts_->touch_count(), impacts_->blows().size(), dt_, evaluations_, least_speed_);
      }
    }
    if (rebuild_) {
      write_back();
      world_.time = time_;
      build({impacts_->obstacles().begin(), impacts_->obstacles().end()});
    }
  }
  world_.report.microsteps += static_cast<int>(microsteps_);
}

double ShockRun::transit_time(const Body& body) const {
  return body.element_size / (body.shock->similarity * bar_wave_speed(world_.material_of(body)));
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

/// The state of an element as it is now, of which the separation tensors are made.
void ShockRun::bring_up_to_date(TetId tet) {
  const int slot = slot_of_tet_[tet];
  if (seen_[slot] == microsteps_) return;
  seen_[slot] = microsteps_;
  Corners corners;
  for (int i = 0; i < 4; ++i) {
    const int index = solid_.corner(slot, i);
    corners.col(i) = world_.nodes.positions[nodes_[index]] = solid_.position(index);
  }
  const Body& body = world_.bodies[world_.elements.bodies[tet]];
  const ElasticLaw law = elastic_law(world_.material_of(body));
  world_.elements.states[tet] =
      element_state(law, element_deformation(law.model, world_.elements.rests[tet], corners),
                    world_.elements.plastic_strains[tet]);
}

void ShockRun::look() {
  ++looks_made_;
  overloaded_.clear();
  for (const int index : flagged_) judge(index);
  std::ranges::sort(overloaded_, [](const Overload& a, const Overload& b) {
    return a.margin != b.margin ? a.margin > b.margin : a.node < b.node;
  });
  for (const Overload& overload : overloaded_) {
    if (rebuild_) break;  // the others are judged again on the new mesh
    if (looks_[local(overload.node)].ready <= time_) open(overload);
  }
}

void ShockRun::judge(int index) {
  Look& seen = looks_[index];
  if (time_ < seen.ready) return;
  const NodeId node = nodes_[index];
  for (const TetId tet : world_.mesh.stars[node]) bring_up_to_date(tet);
  const Body& body = body_of(node);
  const NodeSeparation separation = evaluate_node(world_, separation_input(world_), body, node, false);
  world_.nodes.separations[node] = separation;
  ++evaluations_;
  world_.report.peak_margin = std::max(world_.report.peak_margin, separation.margin);
  if (separation.margin <= 1) return;
  if (seen.last != looks_made_ - 1 || seen.over_since < 0) seen.over_since = time_;
  seen.last = looks_made_;
  const double wait = kOverloadTime * element_size(node) / (body.shock->similarity * bar_wave_speed(world_.material_of(body)));
  if (time_ - seen.over_since + 1e-3 * dt_ >= wait) overloaded_.push_back({separation.margin, node});
}

void ShockRun::open(const Overload& overload) {
  const NodeId node = overload.node;
  const Body& body = body_of(node);
  const BodyId id = body.id;
  const double transit = element_size(node) / (body.shock->similarity * bar_wave_speed(world_.material_of(body)));
  const bool remeshes = world_.scene.bodies[body.scene_body].remeshing;
  if (remeshes) write_back();
  world_.time = time_;
  const std::vector<TetId> star = world_.mesh.stars[node];
  std::vector<std::array<TetId, 4>> neighbours;
  for (const TetId tet : star) neighbours.push_back(world_.mesh.neighbours[tet]);
  const std::size_t first_copy = opened_.copies.size(), tets = world_.mesh.tets.size();
  looks_[local(node)].ready = time_ + transit;
  if (!crack(world_, node, opened_)) {
    rebuild_ |= world_.mesh.tets.size() > tets;
    return;
  }
  ++world_.report.cracks;
  opened_.bodies.insert(id);
  world_.bodies[id].shock->last_event = time_;
  if (world_.crack_events.back().torn_off) world_.bodies[id].system.reset();
  if (world_.mesh.tets.size() > tets || world_.crack_events.back().torn_off) {
    rebuild_ = true;
    return;
  }
  follow(std::span(opened_.copies).subspan(first_copy), star, neighbours);
  for (const TetId tet : star)
    for (const NodeId near : world_.mesh.tets[tet]) {
      Look& waiting = looks_[local(near)];
      waiting = {time_ + (world_.nodes.at_crack_front[near] ? transit / kCrackSpeed : transit), -1, -2};
    }
}

/// Parts the nodes of the solid as those of the mesh were parted.
void ShockRun::follow(std::span<const NodeCopy> copies, const std::vector<TetId>& star,
                      const std::vector<std::array<TetId, 4>>& neighbours) {
  const TetMesh& mesh = world_.mesh;
  local_of_node_.resize(mesh.rest_positions.size(), -1);
  std::map<NodeId, std::vector<NodeId>> parted;
  for (const NodeCopy& copy : copies) parted[copy.original].push_back(copy.copy);
  const auto entries = [&](NodeId node) {
    std::vector<int> star_entries;
    for (const TetId tet : mesh.stars[node]) star_entries.push_back(4 * slot_of_tet_[tet] + local_corner(mesh, tet, node));
    return star_entries;
  };
  for (const auto& [original, made] : parted) {
    const int index = local(original);
    std::vector<std::vector<int>> stars = {entries(original)};
    std::vector<int> locals;
    for (const NodeId copy : made) {
      stars.push_back(entries(copy));
      locals.push_back(solid_.copy_node(index, world_.nodes.masses[copy]));
      local_of_node_[copy] = locals.back();
      nodes_.push_back(copy);
      looks_.emplace_back();
    }
    solid_.node(index).inverse_mass = 1 / world_.nodes.masses[original];
    solid_.part(index, locals, stars);
    update_threshold(index);
    for (const int copy : locals) update_threshold(copy);
  }
  for (std::size_t i = 0; i < star.size(); ++i)
    for (int face = 0; face < 4; ++face) {
      const TetId was = neighbours[i][face];
      if (!was.valid() || mesh.neighbours[star[i]][face].valid() || was < star[i]) continue;
      impacts_->open(sides_of(mesh, star[i], face, was, slot_of_tet_[star[i]], slot_of_tet_[was]));
    }
  for (const TetId tet : star)
    for (const NodeId near : mesh.tets[tet])
      if (world_.nodes.at_crack_front[near]) update_threshold(local(near));
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
    update_elements(world_, body);
    update_motion(world_, body);
    if (!body.rigid) continue;
    body.shock.reset();
    body.shock_ended = time_;
  }
}

}  // namespace griffith
