#include <algorithm>
#include <map>
#include <utility>

#include "sim/core/parallel.h"
#include "sim/geometry/face_key.h"
#include "sim/mesh/topology.h"
#include "sim/world/bodies/bodies.h"
#include "sim/world/bodies/effective_law.h"
#include "sim/world/bodies/quadratic_states.h"
#include "sim/world/explicit/explicit_run.h"
#include "sim/world/explicit/screening.h"
#include "sim/world/explicit/similarity.h"
#include "sim/world/fracture/separation_phase.h"
#include "sim/world/state/element_states.h"
#include "sim/world/state/world_state.h"

namespace griffith {
namespace {

/// Duration of an overload after which a node separates, in the time in which a wave crosses an element.
constexpr double kOverloadTime = 0.75;
/// Largest speed of cracks as a fraction of the bar wave's: about half of the Rayleigh wave's (Freund 1990).
constexpr double kCrackSpeed = 0.3;
/// Elements and nodes that one thread checks: fewer are done before another thread could start.
constexpr int kGrain = 128;
/// Work of the check of a node with the elements around it, and of a crack [µs of a typical core].
constexpr double kCheckWork = 1, kCrackWork = 20;

}  // namespace

explicit_dynamics::CrackSides crack_sides(const TetMesh& mesh, TetId first, int first_face, TetId second,
                                          int first_slot, int second_slot) {
  explicit_dynamics::CrackSides sides{first_slot, second_slot, {}, {}};
  for (int i = 0; i < 3; ++i) {
    sides.first_corners[i] = kTetFaces[first_face][i];
    const Vec3& place = mesh.rest_positions[mesh.tets[first][sides.first_corners[i]]];
    for (int corner = 0; corner < 4; ++corner)
      if (mesh.rest_positions[mesh.tets[second][corner]] == place) sides.second_corners[i] = corner;
  }
  return sides;
}

std::vector<explicit_dynamics::CrackSides> crack_sides(const WorldState& world, std::span<const TetId> tets,
                                                       bool apart) {
  const TetMesh& mesh = world.mesh;
  struct Side {
    int slot = 0, face = 0;
  };
  std::map<std::pair<int, FaceKey>, Side> unpaired;
  std::vector<explicit_dynamics::CrackSides> cracks;
  for (int slot = 0; slot < static_cast<int>(tets.size()); ++slot) {
    const TetId tet = tets[slot];
    if (!tet.valid()) continue;
    for (int face = 0; face < 4; ++face) {
      if (mesh.neighbors[tet][face].valid() || world.elements.first_surface[tet] >> face & 1) continue;
      std::array<Vec3, 3> places;
      for (int i = 0; i < 3; ++i) places[i] = mesh.rest_positions[mesh.tets[tet][kTetFaces[face][i]]];
      const int body = apart ? static_cast<int>(world.elements.bodies[tet].index()) : 0;
      const auto [other, is_new] = unpaired.try_emplace({body, face_key(places)}, Side{slot, face});
      if (is_new) continue;
      const auto [partner, partner_face] = other->second;
      cracks.push_back(crack_sides(mesh, tets[partner], partner_face, tet, partner, slot));
      unpaired.erase(other);
    }
  }
  return cracks;
}

void ExplicitRun::update_threshold(int index) {
  const NodeId node = nodes_[index];
  const bool at_front = world_.nodes.at_crack_front[node] != 0;
  explicit_bodies_.node(index).threshold =
      static_cast<float>(body_of(node).explicit_state->similarity) * screening_stress(world_, node, at_front);
}

/// Returns the time in which a wave crosses an element at the node [s].
double ExplicitRun::transit_time(NodeId node) const {
  return element_size_at(world_, node) / slowed_wave_speed(world_, body_of(node));
}

/// Finds the states of elements of a body as they are now, of which the separation tensors are made.
void ExplicitRun::update_linear_states(std::span<const TetId> tets, const Body& body,
                                       std::vector<ElementState>& states) {
  const PlacedElements placed{effective_elastic_law(world_, body), world_.mesh, world_.elements.rest_elements,
                              world_.nodes.positions};
  find_states(
      placed, tets,
      [&](TetId tet, const FourDeformations& deformations, int lane) {
        if (explicit_bodies_.is_relieved(slot_of_tet_[tet]))
          let_sliver_yield(world_, tet, deformations.strain.of(lane));
        return world_.elements.stress_free_strain(tet);
      },
      [&](TetId tet, const FourStates& found, int lane) { states[tet] = found.of(lane); });
}

void ExplicitRun::update_quadratic_states(std::span<const TetId> tets, const Body& body) {
  std::vector<ElementState>& means = world_.elements.states.edit();
  std::vector<QuadraticState>& states = world_.elements.quadratic_states.edit();
  find_quadratic_stresses(world_, body, tets, [&](TetId tet, const QuadraticStates& found) {
    means[tet] = found.mean;
    states[tet].corners = found.state.corners;
  });
}

/// Takes a tet among those whose states are to be found, and updates its positions.
void ExplicitRun::take_stale(TetId tet) {
  const int slot = slot_of_tet_[tet];
  if (seen_[slot] == microsteps_) return;
  seen_[slot] = microsteps_;
  stale_.push_back(tet);
  for (int i = 0; i < 4; ++i) {
    const int corner = explicit_bodies_.corner(slot, i);
    world_.nodes.positions[nodes_[corner]] = explicit_bodies_.position(corner);
  }
  if (!world_.tet_edges->is_quadratic(tet)) return;
  for (const EdgeId edge : world_.tet_edges->of_tet[tet])
    world_.edges.offsets[edge] = explicit_bodies_.edge_offset(local_of_edge_[edge]);
}

/// Updates the states of all elements around flagged nodes and in their zones, and the positions by which the nodes are
/// split.
void ExplicitRun::update_states_at_flagged() {
  stale_.clear();
  TensionZones zones(world_.mesh, world_.nodes.at_crack_front);
  for (const int index : flagged_) {
    for (const TetId tet : world_.mesh->stars[nodes_[index]]) take_stale(tet);
    for (const TensionZone::Part& part : tension_zone_at(world_, zones, nodes_[index]).parts) take_stale(part.tet);
  }
  const auto body_of_tet = [&](TetId tet) { return world_.elements.bodies[tet]; };
  std::ranges::sort(stale_, {}, [&](TetId tet) { return std::pair(body_of_tet(tet), tet); });
  world_.elements.own_states();
  std::vector<ElementState>& states = world_.elements.states.edit();
  parallel_for(static_cast<int>(stale_.size()), kGrain, [&](int begin, int end) {
    const std::span<const TetId> tets = std::span(stale_).subspan(begin, end - begin);
    for (auto first = tets.begin(); first != tets.end();) {
      const BodyId body = body_of_tet(*first);
      const auto last = std::find_if(first, tets.end(), [&](TetId tet) { return body_of_tet(tet) != body; });
      if (world_.tet_edges->is_quadratic(*first)) {
        update_quadratic_states({first, last}, world_.bodies[body]);
      } else {
        update_linear_states({first, last}, world_.bodies[body], states);
      }
      first = last;
    }
  });
}

void ExplicitRun::check_overload() {
  const double last_check = std::exchange(world_.overload_check, time_);
  overloaded_.clear();
  std::erase_if(flagged_, [&](int index) { return !can_be_overloaded(index); });
  work_ += kCheckWork * static_cast<double>(flagged_.size());
  update_states_at_flagged();
  const SeparationInput input = separation_input(world_);
  std::vector<NodeId> checked;
  for (const int index : flagged_) checked.push_back(nodes_[index]);
  parallel_for(static_cast<int>(checked.size()), kGrain, [&](int begin, int end) {
    evaluate_nodes(world_, input, std::span(checked).subspan(begin, end - begin), false);
  });
  for (const NodeId node : checked) update_overload(node, last_check);
  std::ranges::sort(overloaded_, [](const Overload& a, const Overload& b) {
    return a.utilization != b.utilization ? a.utilization > b.utilization : a.node < b.node;
  });
  world_.report.cracks_postponed = 0;
  const std::size_t first_event = world_.crack_events.size();
  for (const Overload& overload : overloaded_) {
    if (rebuild_) break;  // the others are judged again on the new mesh
    if (world_.report.cracks >= world_.model->scene.simulation.max_cracks_per_step) {
      ++world_.report.cracks_postponed;
    } else if (world_.nodes.overloads[overload.node].known_from <= time_) {
      open(overload);
    }
  }
  if (world_.crack_events.size() > first_event && !rebuild_) contacts_->tie_edges(explicit_bodies_);
}

/// Takes a node that has been overloaded for long enough among those that open. `last_check`: before this one [s].
void ExplicitRun::update_overload(NodeId node, double last_check) {
  OverloadHistory& history = world_.nodes.overloads[node];
  const double utilization = world_.nodes.separations[node].utilization;
  world_.report.peak_utilization = std::max(world_.report.peak_utilization, utilization);
  if (utilization <= 1) return;
  if (history.last == OverloadHistory::kNever || history.last != last_check) history.since = time_;
  history.last = time_;
  const double wait = kOverloadTime * transit_time(node);
  if (time_ - history.since + 1e-3 * dt_ >= wait) overloaded_.push_back({utilization, node});
}

/// Returns the nodes of these tets at which a crack ends.
std::vector<NodeId> ExplicitRun::front_among(const std::vector<TetId>& tets) const {
  std::vector<NodeId> front;
  for (const TetId tet : tets)
    for (const NodeId node : world_.mesh->tets[tet])
      if (world_.nodes.at_crack_front[node]) front.push_back(node);
  return front;
}

void ExplicitRun::open(const Overload& overload) {
  const NodeId node = overload.node;
  const Body& body = body_of(node);
  const BodyId id = body.id;
  const double transit = transit_time(node);
  if (world_.model->scene.bodies[body.scene_body].remeshing) {
    write_back(world_);
    world_.bodies[id].nodes = nodes_of(world_.mesh, body.tets);  // with the copies of earlier cracks
  }
  world_.time = time_;
  const std::vector<TetId> star = world_.mesh->stars[node];
  std::vector<std::array<TetId, 4>> neighbors;
  for (const TetId tet : star) neighbors.push_back(world_.mesh->neighbors[tet]);
  const std::vector<NodeId> front = front_among(star);
  const std::size_t first_copy = opened_.copies.size(), tets = world_.mesh->tets.size();
  const std::size_t first_edge_copy = opened_.edge_copies.size();
  world_.nodes.overloads[node].known_from = time_ + transit;
  const bool cracked = crack(world_, node, opened_);
  if (world_.mesh->tets.size() > tets) {
    restore_momenta(world_, opened_.motions);
    rebuild_ = true;
  }
  opened_.motions.clear();
  if (!cracked) return;
  ++world_.report.cracks;
  work_ += kCrackWork;
  opened_.bodies.insert(id);
  world_.bodies[id].explicit_state->last_event = time_;
  const bool torn_off = world_.crack_events.back().torn_off;
  if (torn_off) world_.bodies[id].system.reset();
  wait_beside_crack(star, front, transit);
  if (rebuild_) return;
  follow(overload, std::span(opened_.copies).subspan(first_copy), star, neighbors);
  follow_edges(std::span(opened_.edge_copies).subspan(first_edge_copy));
  if (torn_off) constrain_again();
}

/// Delays further cracks beside a crack. Nodes of the tets beside it count as overloaded only once their stress is
/// known again, and new ones at its front once it could have run there. `front`: nodes at the crack's front before.
void ExplicitRun::wait_beside_crack(const std::vector<TetId>& star, const std::vector<NodeId>& front, double transit) {
  for (const TetId tet : star)
    for (const NodeId near : world_.mesh->tets[tet]) {
      const bool new_front = world_.nodes.at_crack_front[near] && std::ranges::find(front, near) == front.end();
      world_.nodes.overloads[near] = {.known_from = time_ + (new_front ? transit / kCrackSpeed : transit)};
    }
}

/// Updates the constraints of nodes and edges.
void ExplicitRun::constrain_again() {
  for (const explicit_dynamics::ExplicitConstraint& held : explicit_bodies_.constraints())
    explicit_bodies_.constrain(held.node, world_.nodes.constraints[nodes_[held.node]]);
  for (int i = 0; i < explicit_bodies_.edge_count(); ++i) {
    const auto& [a, b] = world_.tet_edges->ends[edges_[i]];
    explicit_bodies_.constrain_edge(
        i, constraint_between(world_.nodes.constraints[a], world_.nodes.constraints[b]).allowed);
  }
}

/// Splits the explicit edges like those of the mesh.
void ExplicitRun::follow_edges(std::span<const EdgeCopy> copies) {
  const TetEdges& topology = world_.tet_edges;
  local_of_edge_.resize(world_.edges.offsets.size(), -1);
  std::map<EdgeId, std::vector<EdgeId>> parted;
  for (const EdgeCopy& copy : copies) parted[copy.original].push_back(copy.copy);
  const auto entries = [&](EdgeId edge) {
    std::vector<int> star_entries;
    for (const TetId tet : world_.mesh->stars[topology.ends[edge][0]])
      for (int i = 0; i < 6; ++i)
        if (topology.of_tet[tet][i] == edge) star_entries.push_back(explicit_bodies_.edge_entry(slot_of_tet_[tet], i));
    return star_entries;
  };
  for (const auto& [original, made] : parted) {
    const int index = local_of_edge_[original];
    std::vector<std::vector<int>> stars = {entries(original)};
    std::vector<int> locals;
    for (const EdgeId copy : made) {
      stars.push_back(entries(copy));
      locals.push_back(explicit_bodies_.copy_edge(index, world_.edges.masses[copy]));
      local_of_edge_[copy] = locals.back();
      edges_.push_back(copy);
      edge_starts_.push_back(Start(edge_starts_[index]));
      for (ChangingLoad& changing : changing_loads_) copy_loaded(index, locals.back(), changing.edges);
    }
    explicit_bodies_.edge(index).inverse_mass = 1 / world_.edges.masses[original];
    explicit_bodies_.part_edge(index, locals, stars);
  }
}

/// Splits the explicit nodes like those of the mesh.
void ExplicitRun::follow(const Overload& overload, std::span<const NodeCopy> copies, const std::vector<TetId>& star,
                         const std::vector<std::array<TetId, 4>>& neighbors) {
  const TetMesh& mesh = world_.mesh;
  local_of_node_.resize(mesh.rest_positions.size(), -1);
  std::map<NodeId, std::vector<NodeId>> parted;
  for (const NodeCopy& copy : copies) parted[copy.original].push_back(copy.copy);
  const auto entries = [&](NodeId node) {
    std::vector<int> star_entries;
    for (const TetId tet : mesh.stars[node])
      star_entries.push_back(4 * slot_of_tet_[tet] + local_corner(mesh, tet, node));
    return star_entries;
  };
  for (const auto& [original, made] : parted) {
    const int index = local(original);
    std::vector<std::vector<int>> stars = {entries(original)};
    std::vector<int> locals;
    for (const NodeId copy : made) {
      stars.push_back(entries(copy));
      locals.push_back(explicit_bodies_.copy_node(index, world_.nodes.masses[copy]));
      local_of_node_[copy] = locals.back();
      nodes_.push_back(copy);
      starts_.push_back(Start(starts_[index]));
      for (ChangingLoad& changing : changing_loads_) copy_loaded(index, locals.back(), changing.nodes);
    }
    explicit_bodies_.node(index).inverse_mass = 1 / world_.nodes.masses[original];
    explicit_bodies_.part(index, locals, stars);
    update_threshold(index);
    for (const int copy : locals) update_threshold(copy);
  }
  for (std::size_t i = 0; i < star.size(); ++i)
    for (int face = 0; face < 4; ++face) {
      const TetId was = neighbors[i][face];
      if (!was.valid() || mesh.neighbors[star[i]][face].valid() || was < star[i]) continue;
      const int crack = contacts_->open(
          explicit_bodies_, crack_sides(mesh, star[i], face, was, slot_of_tet_[star[i]], slot_of_tet_[was]));
      cracks_by_face_.add(*contacts_, crack);
    }
  for (const auto& [original, made] : parted)
    bond_copies(original, made, original == overload.node ? overload.utilization : 1);
  for (const TetId tet : star)
    for (const NodeId near : mesh.tets[tet])
      if (world_.nodes.at_crack_front[near]) update_threshold(local(near));
}

}  // namespace griffith
