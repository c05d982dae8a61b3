#include <algorithm>
#include <map>
#include <set>

#include "sim/core/tet_edge_corners.h"
#include "sim/elasticity/principal_stress.h"
#include "sim/explicit/explicit_bodies.h"
#include "sim/explicit/stars.h"
#include "sim/geometry/disjoint_sets.h"

namespace griffith::explicit_dynamics {
namespace {

/// Returns the projector onto the directions in which all of some edges may move.
Mat3 allowed_to_all(const std::vector<ExplicitEdge>& edges, std::span<const int> tied) {
  constexpr double kNone = 1e-6;
  Mat3 blocked = Mat3::Zero(), allowed = Mat3::Zero();
  for (const int edge : tied) blocked += Mat3::Identity() - edges[edge].allowed;
  const PrincipalValues found = principal_values(blocked);
  for (int i = 0; i < 3; ++i)
    if (found.values[i] < kNone) allowed += found.directions.col(i) * found.directions.col(i).transpose();
  return allowed;
}

bool are_free(const std::vector<ExplicitEdge>& edges, std::span<const int> tied) {
  return std::ranges::all_of(tied, [&](int edge) { return edges[edge].is_free; });
}

}  // namespace

int ExplicitBodies::add_edge(const ExplicitEdgeStart& start) {
  edges_.push_back({.inverse_mass = 1 / start.mass, .acceleration = start.acceleration});
  constrain_edge(edge_count() - 1, start.allowed);
  edge_offsets_.push_back({wide(start.offset)});
  edge_velocities_.push_back({wide(start.velocity)});
  return edge_count() - 1;
}

int ExplicitBodies::copy_edge(int edge, double mass) {
  return add_edge({edge_offset(edge), edge_velocity(edge), mass, edges_[edge].allowed, edges_[edge].acceleration});
}

void ExplicitBodies::constrain_edge(int edge, const Mat3& allowed) {
  edges_[edge].allowed = allowed;
  edges_[edge].is_free = allowed.isIdentity(0);
}

void ExplicitBodies::list_edge_stars() {
  edge_forces_.resize(6 * static_cast<std::size_t>(kLanes) * quadratics_.size());
  const auto each_entry = [&](auto use) {
    for (std::size_t b = 0; b < blocks_.size(); ++b) {
      if (quadratic_of_block_[b] < 0) continue;
      for (int lane = 0; lane < kLanes; ++lane)
        for (int i = 0; i < 6 && blocks_[b].volume[lane] > 0; ++i)
          use(quadratics_[quadratic_of_block_[b]].edges[i][lane], 6 * (kLanes * quadratic_of_block_[b] + lane) + i);
    }
  };
  list_stars(each_entry, edges_, edge_stars_);
}

int ExplicitBodies::edge_entry(int slot, int edge) const {
  return 6 * (kLanes * quadratic_of_block_[slot / kLanes] + slot % kLanes) + edge;
}

void ExplicitBodies::part_edge(int edge, std::span<const int> copies, std::span<const std::vector<int>> stars) {
  int at = edges_[edge].first;
  for (std::size_t i = 0; i < stars.size(); ++i) {
    const int owner = i == 0 ? edge : copies[i - 1];
    edges_[owner].first = at;
    edges_[owner].count = static_cast<int>(stars[i].size());
    for (const int entry : stars[i]) {
      edge_stars_[at++] = entry;
      parted_.push_back(slot_of_edge_entry(entry));
      quadratics_[entry / 6 / kLanes].edges[entry % 6][entry / 6 % kLanes] = owner;
    }
  }
}

int ExplicitBodies::edge_between(int slot, int corner, int other) const {
  return quadratics_[quadratic_of_block_[slot / kLanes]].edges[tet_edge(corner, other)][slot % kLanes];
}

double ExplicitBodies::tie_edges(std::span<const std::pair<int, int>> pairs) {
  for (ExplicitEdge& edge : edges_) edge.tie = -1;
  ties_.clear();
  const std::vector<int> groups = connected_groups(edge_count(), pairs);
  std::map<int, std::set<int>> tied;
  for (const auto& [first, second] : pairs) tied[groups[first]].insert({first, second});
  double lost = 0;
  for (const auto& [group, members] : tied) {
    for (const int edge : members) edges_[edge].tie = static_cast<int>(ties_.size());
    ties_.emplace_back(members.begin(), members.end());
    lost += move_alike(ties_.back());
  }
  return lost;
}

/// Gives edges the velocity of their common momentum, where supports let all of them move. Returns the kinetic energy
/// that this takes [J].
double ExplicitBodies::move_alike(std::span<const int> tied) {
  Vec3 momentum = Vec3::Zero();
  double mass = 0, lost = 0;
  for (const int edge : tied) {
    momentum += edge_velocity(edge) / edges_[edge].inverse_mass;
    mass += 1 / edges_[edge].inverse_mass;
  }
  Vec3 common = momentum / mass;
  if (!are_free(edges_, tied)) common = allowed_to_all(edges_, tied) * common;
  for (const int edge : tied) {
    const Vec3 before = edge_velocity(edge);
    lost += 0.5 / edges_[edge].inverse_mass * (before - common).dot(before + common);
    edge_velocities_[edge].value = wide(common);
  }
  return lost;
}

std::span<const int> ExplicitBodies::tied_to(const int& edge) const {
  return edges_[edge].tie < 0 ? std::span(&edge, 1) : std::span(ties_[edges_[edge].tie]);
}

Vec3 ExplicitBodies::edge_force(int index) const {
  const ExplicitEdge& edge = edges_[index];
  WideQuad force = wide(edge.acceleration / edge.inverse_mass);
  for (int e = edge.first; e < edge.first + edge.count; ++e)
    force += __builtin_convertvector(edge_forces_[edge_stars_[e]].value, WideQuad);
  return vector(force);
}

/// Returns the acceleration of edges that move alike, where supports let all of them move [m/s²].
Vec3 ExplicitBodies::common_acceleration(std::span<const int> tied) const {
  Vec3 force = Vec3::Zero();
  double mass = 0;
  for (const int edge : tied) force += edge_force(edge), mass += 1 / edges_[edge].inverse_mass;
  const Vec3 common = force / mass;
  return are_free(edges_, tied) ? common : Vec3(allowed_to_all(edges_, tied) * common);
}

Vec3 ExplicitBodies::edge_acceleration(int index) const { return common_acceleration(tied_to(index)); }

void ExplicitBodies::advance_edges(double kick, double drift) {
  std::vector<WideQuad> of_ties;
  for (const std::vector<int>& tied : ties_) of_ties.push_back(wide(kick * common_acceleration(tied)));
  for (int i = 0; i < edge_count(); ++i) {
    const ExplicitEdge& edge = edges_[i];
    WideQuad& velocity = edge_velocities_[i].value;
    velocity += edge.tie >= 0 ? of_ties[edge.tie] : kick_of(edge, kick);
    edge_offsets_[i].value += drift * velocity;
  }
}

/// Returns by how much the forces on an edge that moves by itself change its velocity in the time `kick` [s] [m/s].
WideQuad ExplicitBodies::kick_of(const ExplicitEdge& edge, double kick) const {
  Quad sum = {};
  for (int e = edge.first; e < edge.first + edge.count; ++e) sum += edge_forces_[edge_stars_[e]].value;
  const WideQuad force = __builtin_convertvector(sum, WideQuad);
  WideQuad push = kick * (edge.inverse_mass * force + wide(edge.acceleration));
  if (!edge.is_free) push = wide(edge.allowed * vector(push));
  push[3] = 0;
  return push;
}

}  // namespace griffith::explicit_dynamics
