#include "sim/world/contact/large_strains.h"

#include <Eigen/LU>
#include <algorithm>
#include <memory>

#include "sim/core/parallel.h"
#include "sim/core/sort_unique.h"
#include "sim/elasticity/compaction.h"
#include "sim/world/bodies/bodies.h"
#include "sim/world/bodies/effective_law.h"
#include "sim/world/contact/elastic_contacts.h"
#include "sim/world/contact/respond.h"
#include "sim/world/motion/deformation.h"
#include "sim/world/motion/elastic_phase.h"
#include "sim/world/motion/motion_phase.h"
#include "sim/world/state/corners.h"

namespace griffith {
namespace {

/// Nonlinear step of one body. Its nodes are at their start between the calls.
class LargeStrain {
 public:
  LargeStrain(WorldState& world, Body& body, const std::vector<Vec3>& external, double dt)
      : world_(world),
        body_(body),
        before_(snapshot(world, body)),
        whole_(whole_motion(world, body, dt)),
        carried_(carried()),
        deformation_(world, body, before_, whole_.exists() ? places() : NodeVectors(places() + dt * carried_), dt,
                     true) {
    deformation_.set_load(external, carried_);
    deformation_.place(NodeVectors::Zero(3, carried_.cols()));
    advance();
  }

  /// Linearizes the step at the last velocities, and gives the body those without contacts. `free`: those of the step
  /// linearized at the start, per node of the mesh [m/s].
  void linearize(const std::vector<Vec3>& free) {
    set_velocities(whole_part(gather(free)) + deformation_.without_contacts(deformation_.deforming()));
    move_back();
  }

  /// Moves on toward the present velocities, which are those with contacts.
  void advance() {
    const NodeVectors solved = velocities(), whole = whole_part(solved);
    deformation_.take_contacts();
    deformation_.place(deformation_.deforming());
    share_ = deformation_.search_along(solved - whole - deformation_.deforming());
    const auto [left, all] = deformation_.balance();
    course_.push_back(all > 0 ? left / all : 0);
    set_velocities(whole + deformation_.deforming());
    move_back();
  }

  /// True if some rounds have brought it no closer to balance.
  bool is_hopeless() const {
    constexpr int kRounds = 4;
    constexpr double kCloser = 0.9, kFar = 0.3;
    const std::size_t count = course_.size();
    return count > kRounds + 1 && course_.back() > kFar && course_.back() > kCloser * course_[count - 1 - kRounds];
  }
  /// Returns what is left of the impulses, as a share of them; all if the last round did not reach its solution.
  double imbalance() const { return share_ == 1 ? course_.back() : 1; }

  /// Takes the work of the contacts at the present velocities.
  void account_contacts() {
    world_.scratch.bodies[body_.id].contact_work = dot(gather(world_.scratch.contact_impulses), velocities());
  }

  BodyId body() const { return body_.id; }

 private:
  NodeVectors gather(const std::vector<Vec3>& of_nodes) const { return body_.system->gather(of_nodes); }
  NodeVectors places() const { return gather(world_.nodes.positions); }
  NodeVectors velocities() const { return gather(world_.nodes.velocities); }
  NodeVectors whole_part(const NodeVectors& of) const { return whole_.exists() ? whole_.part_of(of) : carried_; }
  NodeVectors carried() {
    const NodeVectors solved = velocities();
    keep_whole_motion(world_, body_);
    const NodeVectors carried = velocities();
    set_velocities(solved);
    return carried;
  }
  void set_velocities(const NodeVectors& of_rows) {
    const std::span<const NodeId> nodes = body_.system->nodes();
    for (std::size_t i = 0; i < nodes.size(); ++i) world_.nodes.velocities[nodes[i]] = of_rows.col(i);
  }
  void move_back() {
    for (std::size_t i = 0; i < body_.nodes.size(); ++i) world_.nodes.positions[body_.nodes[i]] = before_.positions[i];
    restore_plastic_strains(world_, body_, before_);
    update_elements(world_, body_);
  }

  WorldState& world_;
  Body& body_;
  BodySnapshot before_;
  WholeMotion whole_;
  NodeVectors carried_;  ///< velocities of its rows if they follow its supports
  Deformation deformation_;
  double share_ = 0;            // of the way to the solution of the last round
  std::vector<double> course_;  // imbalance after each round
};

/// True if the present velocities compact a tet of a soft body, one is compacted, or the step would gain energy.
bool strains_far(WorldState& world, const Body& body, const std::vector<Vec3>& external, double dt) {
  if (!body.is_deformable() || body.quasi_static || !deforms_visibly(world, body)) return false;
  const ElasticLaw law = effective_elastic_law(world, body);
  if (law.compaction == 0) return false;
  const auto is_compacted = [&](TetId tet) {
    if (world.elements.states[tet].is_compacted()) return true;
    const Corners moved =
        corners_of(world.mesh, tet, world.nodes.positions) + dt * corners_of(world.mesh, tet, world.nodes.velocities);
    return is_compacted_at(law, deformation_gradient(world.elements.rest_elements[tet], moved).determinant());
  };
  return std::ranges::any_of(body.tets, is_compacted) || would_gain_energy(world, body, external, dt);
}

/// Rounds of nonlinear steps, of each group of bodies together with their contacts.
class StrainRounds {
 public:
  StrainRounds(WorldState& world, SolvedContacts& solved, const std::vector<Vec3>& external,
               const BeforeContacts& before, double dt)
      : world_(world),
        solved_(solved),
        before_(before),
        dt_(dt),
        group_of_body_(world.bodies.size(), -1),
        is_open_(solved.groups.size(), false) {
    for (Body& body : world.bodies) {
      if (!strains_far(world, body, external, dt)) continue;
      world.scratch.tangents.resize(world.mesh->tets.size());
      strained_.push_back(std::make_unique<LargeStrain>(world, body, external, dt));
    }
    for (std::size_t i = 0; i < solved.groups.size(); ++i) {
      for (const int touched : solved.groups[i].touched)
        group_of_body_[solved.touched.bodies[touched].body] = static_cast<int>(i);
      is_open_[i] = still_turns(solved.groups[i]);
    }
    for (const Strained& of : strained_) open_group_of(*of);
  }

  bool is_done() const {
    return std::ranges::none_of(is_open_, [](char open) { return open; }) &&
           std::ranges::all_of(strained_, [&](const Strained& of) { return of->imbalance() <= kBalanced; });
  }

  bool is_hopeless() const {
    return std::ranges::any_of(strained_, [](const Strained& of) { return of->is_hopeless(); });
  }

  void make_round() {
    std::vector<LargeStrain*> strained;
    for (const Strained& of : strained_)
      if (of->imbalance() > kBalanced || is_open(*of)) strained.push_back(of.get());
    const std::vector<int> touched = open_bodies();
    for (const int i : touched) release(world_.bodies[solved_.touched.bodies[i].body]);
    for_each(strained, [&](LargeStrain& of) { of.linearize(before_.velocities); });
    choose_tolerances(strained);
    solve_again(world_, solved_.touched, open_groups(), dt_);
    respond(world_, solved_.touched, touched, dt_);
    for_each(strained, [](LargeStrain& of) { of.advance(); });
    for (std::size_t i = 0; i < is_open_.size(); ++i)
      if (is_open_[i]) is_open_[i] = still_turns(solved_.groups[i]) || solved_.groups[i].tolerance > kFine;
    for (const LargeStrain* of : strained)
      if (of->imbalance() > kBalanced) open_group_of(*of);
  }

  /// Returns how bodies will move.
  std::vector<ElasticMove> finish() {
    std::vector<ElasticMove> moves(world_.bodies.size(), ElasticMove::linearized);
    for (const Strained& of : strained_) {
      moves[of->body()] = of->imbalance() <= kBalanced ? ElasticMove::nonlinear : ElasticMove::unconverged;
      of->account_contacts();
    }
    return moves;
  }

 private:
  using Strained = std::unique_ptr<LargeStrain>;
  static constexpr double kBalanced = 0.03;  // of impulses: far below what a step of implicit Euler loses there
  static constexpr double kFine = 1e-3;      // tolerance of contacts at the end

  template <class Visit>
  static void for_each(const std::vector<LargeStrain*>& strained, const Visit& visit) {
    parallel_for(static_cast<int>(strained.size()), 1, [&](int begin, int end) {
      for (int i = begin; i < end; ++i) visit(*strained[i]);
    });
  }

  bool is_open(const LargeStrain& of) const {
    const int group = group_of_body_[of.body()];
    return group >= 0 && is_open_[group];
  }

  void open_group_of(const LargeStrain& of) {
    const int group = group_of_body_[of.body()];
    if (group >= 0) is_open_[group] = true;
  }

  std::vector<ContactGroup*> open_groups() {
    std::vector<ContactGroup*> groups;
    for (std::size_t i = 0; i < is_open_.size(); ++i)
      if (is_open_[i]) groups.push_back(&solved_.groups[i]);
    return groups;
  }

  /// Contacts need not be more exact than the bodies are.
  void choose_tolerances(const std::vector<LargeStrain*>& strained) {
    constexpr double kOfImbalance = 0.03;
    for (ContactGroup& group : solved_.groups) group.tolerance = 0;
    for (const LargeStrain* of : strained)
      if (const int group = group_of_body_[of->body()]; group >= 0)
        solved_.groups[group].tolerance = std::max(solved_.groups[group].tolerance, kOfImbalance * of->imbalance());
  }

  /// True if bodies turn otherwise than their contacts have been solved for.
  bool still_turns(const ContactGroup& group) {
    constexpr double kTolerance = 2e-4;  // of an element
    bool turns = false;
    for (const int i : group.touched) {
      TouchedBody& touched = solved_.touched.bodies[i];
      turns |= foresee_turn(world_, touched, dt_) > kTolerance * world_.bodies[touched.body].element_size;
    }
    return turns;
  }

  /// Returns the indices of the touched bodies with contacts in open groups.
  std::vector<int> open_bodies() const {
    std::vector<char> is_open(world_.contact_world.contacts().size(), false);
    std::vector<int> bodies;
    for (std::size_t i = 0; i < is_open_.size(); ++i) {
      for (const int contact : solved_.groups[i].contacts) is_open[contact] = is_open_[i];
      if (is_open_[i]) bodies.insert(bodies.end(), solved_.groups[i].touched.begin(), solved_.groups[i].touched.end());
    }
    for (std::size_t i = 0; i < solved_.touched.objects.size(); ++i)
      if (std::ranges::any_of(solved_.touched.objects[i].contacts, [&](int contact) { return is_open[contact]; }))
        bodies.push_back(static_cast<int>(i));
    sort_unique(bodies);
    return bodies;
  }

  /// Takes back what contacts did to a body.
  void release(const Body& body) {
    for (const NodeId node : body.nodes) world_.nodes.velocities[node] = before_.velocities[node];
    for (const EdgeId edge : body.edges) world_.edges.velocities[edge] = before_.edge_velocities[edge];
    for (const NodeId node : body.system->supports()) world_.nodes.reactions[node] = before_.reactions[node];
  }

  WorldState& world_;
  SolvedContacts& solved_;
  const BeforeContacts& before_;
  double dt_;
  std::vector<Strained> strained_;
  std::vector<int> group_of_body_;  // by BodyId, -1 for none
  std::vector<char> is_open_;       // per group: to be solved again
};

}  // namespace

bool may_strain_far(const WorldState& world) {
  return std::ranges::any_of(world.bodies, [&](const Body& body) { return can_be_compacted(world, body); });
}

std::vector<ElasticMove> resolve_large_strains(WorldState& world, SolvedContacts& solved,
                                               const std::vector<Vec3>& external, const BeforeContacts& before,
                                               double dt) {
  constexpr int kMaxRounds = 30;
  if (!may_strain_far(world)) return std::vector<ElasticMove>(world.bodies.size(), ElasticMove::linearized);
  StrainRounds rounds(world, solved, external, before, dt);
  int made = 0;
  for (; made < kMaxRounds && !rounds.is_done() && !rounds.is_hopeless(); ++made) rounds.make_round();
  return rounds.finish();
}

}  // namespace griffith
