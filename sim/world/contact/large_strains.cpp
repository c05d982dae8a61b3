#include "sim/world/contact/large_strains.h"

#include <Eigen/LU>
#include <algorithm>
#include <memory>

#include "sim/core/parallel.h"
#include "sim/elasticity/compaction.h"
#include "sim/world/bodies/bodies.h"
#include "sim/world/bodies/effective_law.h"
#include "sim/world/contact/elastic_contacts.h"
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
        deformation_(world, body, before_, whole_.exists() ? places() : NodeVectors(places() + dt * carried_), dt) {
    deformation_.set_load(external, carried_);
    deformation_.place(NodeVectors::Zero(3, carried_.cols()));
    advance();
  }

  /// Linearizes the step at the last velocities, and gives the body those without contacts.
  void linearize(const NodeVectors& free) {
    set_velocities(whole_part(free) + deformation_.without_contacts(deformation_.deforming()));
    move_back();
  }

  /// Moves on toward the present velocities, which are those with contacts. True if nothing remains to be done.
  bool advance() {
    constexpr double kTolerance = 0.01;  // far below what a step of implicit Euler loses there
    const NodeVectors solved = velocities(), whole = whole_part(solved);
    deformation_.take_contacts();
    deformation_.place(deformation_.deforming());
    const double share = deformation_.search_along(solved - whole - deformation_.deforming());
    const bool is_done = share == 1 && deformation_.is_balanced(kTolerance);
    set_velocities(whole + deformation_.deforming());
    move_back();
    return is_done;
  }

  /// Accounts for the work of the contacts at the present velocities, if these are not those with which it was found.
  void account_contacts() {
    double& work = world_.scratch.bodies[body_.id].contact_work;
    const double now = dot(gather(world_.scratch.contact_impulses), velocities());
    world_.energy.contacts += work - now;
    work = now;
  }

  NodeVectors gather(const std::vector<Vec3>& of_nodes) const { return body_.system->gather(of_nodes); }
  BodyId body() const { return body_.id; }

 private:
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

}  // namespace

bool may_strain_far(const WorldState& world) {
  constexpr int kMaxBodies = 5;
  const auto count =
      std::ranges::count_if(world.bodies, [&](const Body& body) { return can_be_compacted(world, body); });
  return 1 <= count && count <= kMaxBodies;
}

std::vector<ElasticMove> resolve_large_strains(WorldState& world, const std::vector<Vec3>& external,
                                               const std::vector<Vec3>& free, double dt,
                                               const std::function<void()>& solve) {
  constexpr int kMaxRounds = 8;
  std::vector<ElasticMove> moves(world.bodies.size(), ElasticMove::linearized);
  std::vector<std::unique_ptr<LargeStrain>> strained;
  for (Body& body : world.bodies)
    if (strains_far(world, body, external, dt))
      strained.push_back(std::make_unique<LargeStrain>(world, body, external, dt));
  const auto count = static_cast<int>(strained.size());
  std::vector<char> done(strained.size(), false);
  for (int round = 0; round < kMaxRounds && std::ranges::count(done, true) < count; ++round) {
    world.nodes.velocities = free;
    parallel_for(count, 1, [&](int begin, int end) {
      for (int i = begin; i < end; ++i) strained[i]->linearize(strained[i]->gather(free));
    });
    solve();
    parallel_for(count, 1, [&](int begin, int end) {
      for (int i = begin; i < end; ++i) done[i] = strained[i]->advance();
    });
  }
  for (int i = 0; i < count; ++i) {
    moves[strained[i]->body()] = done[i] ? ElasticMove::nonlinear : ElasticMove::unconverged;
    strained[i]->account_contacts();
  }
  return moves;
}

}  // namespace griffith
