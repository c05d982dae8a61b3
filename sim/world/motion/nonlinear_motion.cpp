#include <cmath>

#include "sim/solver/conjugate_gradient.h"
#include "sim/world/contact/elastic_contacts.h"
#include "sim/world/motion/elastic_phase.h"
#include "sim/world/motion/motion_phase.h"

namespace griffith {
namespace {

/// Minimization of one body's step.
class Deformation {
 public:
  /// `start`: positions of the rows of the body's system after it moved without deformation, nodes and then edges [m].
  Deformation(WorldState& world, Body& body, const BodySnapshot& before, NodeVectors start, double dt)
      : world_(world), body_(body), before_(before), dt_(dt), start_(std::move(start)) {
    const Material& material = world.material_of(body);
    inertia_ = masses() * (1 + dt * material.mass_damping);
    damping_share_ = material.stiffness_damping / (dt + material.stiffness_damping);
    whole_ = whole_motion(world, body, dt);
  }

  /// Sets M v + h f + p of the start, without the part that moves the whole: nodes have its velocities now.
  void set_load(const std::vector<Vec3>& external) {
    const SubstepStart& start = world_.scratch.substep_start;
    const ElasticSystem& system = *body_.system;
    load_ = system.gather(start.velocities, start.edge_velocities) * masses().asDiagonal();
    load_ += dt_ * system.gather(external, world_.scratch.edge_loads) + system.gather(world_.scratch.contact_impulses);
    if (whole_.exists()) return remove_whole(load_);
    load_ -= system.gather(world_.nodes.velocities, world_.edges.velocities) * inertia_.asDiagonal();
  }

  /// Finds the velocities that deform it, from a guess; false where that does not converge.
  bool minimize(NodeVectors e) {
    constexpr int kMaxSteps = 30;
    double energy = 0;
    choose_start(e, energy);
    for (int step = 0; step < kMaxSteps; ++step) {
      assemble_system(world_, body_, dt_);
      NodeVectors forces = elastic_impulses(), residual = load_ + forces - resistance(e);
      project(residual);
      const double scale = std::sqrt(dot(forces, forces)) + std::sqrt(dot(load_, load_));
      const double tolerance = world_.model->scene.simulation.relative_residual;
      if (std::sqrt(dot(residual, residual)) <= tolerance * scale) return true;
      if (!search_along(direction(residual), e, energy)) return false;
    }
    return false;
  }

  /// Moves the rows by these velocities.
  void place(const NodeVectors& e) {
    for (std::size_t i = 0; i < before_.plastic_strains.size(); ++i)
      world_.elements.plastic_strains[body_.tets[i]] = before_.plastic_strains[i];
    const NodeVectors places = start_ + dt_ * e;
    const std::span<const NodeId> nodes = body_.system->nodes();
    const std::span<const EdgeId> edges = body_.system->edges();
    for (std::size_t i = 0; i < nodes.size(); ++i) world_.nodes.positions[nodes[i]] = places.col(i);
    for (std::size_t i = 0; i < edges.size(); ++i) world_.edges.offsets[edges[i]] = places.col(nodes.size() + i);
    update_elements(world_, body_);
    deforming_ = e;
  }
  const NodeVectors& deforming() const { return deforming_; }

 private:
  Eigen::VectorXd masses() const {
    const std::span<const NodeId> nodes = body_.system->nodes();
    const std::span<const EdgeId> edges = body_.system->edges();
    Eigen::VectorXd masses(body_.system->rows());
    for (std::size_t i = 0; i < nodes.size(); ++i) masses[i] = world_.nodes.masses[nodes[i]];
    for (std::size_t i = 0; i < edges.size(); ++i) masses[nodes.size() + i] = world_.edges.masses[edges[i]];
    return masses;
  }
  void remove_whole(NodeVectors& impulses) const {
    if (whole_.exists()) impulses -= whole_.momentum_of(impulses);
  }
  void project(NodeVectors& impulses) const {
    remove_whole(impulses);
    body_.system->project(impulses);
  }

  /// Begins with the guess, or from rest where that has less energy.
  void choose_start(NodeVectors& e, double& energy) {
    place(NodeVectors::Zero(3, e.cols()));
    const double at_rest = energy_at(deforming_);
    place(e);
    energy = energy_at(e);
    if (energy <= at_rest) return;
    e.setZero();
    place(e);
    energy = at_rest;
  }

  /// Returns h f of the elastic forces at the present positions.
  NodeVectors elastic_impulses() const {
    std::vector<Vec3> forces(world_.nodes.positions.size(), Vec3::Zero());
    add_elastic_forces(world_, body_, forces, world_.scratch);
    return dt_ * body_.system->gather(forces, world_.scratch.edge_forces);
  }
  /// Returns the resistance of mass and damping to the velocities: M e + h β K e.
  NodeVectors resistance(const NodeVectors& e) const {
    const NodeVectors by_mass = e * inertia_.asDiagonal();
    if (damping_share_ == 0) return by_mass;
    NodeVectors product;
    multiply(body_.system->matrix(), e, product);
    return by_mass + damping_share_ * (product - by_mass);
  }
  double energy_at(const NodeVectors& e) const {
    return elastic_energy(world_, body_) + 0.5 * dot(e, resistance(e)) - dot(e, load_);
  }

  NodeVectors direction(const NodeVectors& residual) const {
    constexpr double kForcing = 0.01;
    NodeVectors d = NodeVectors::Zero(3, residual.cols());
    conjugate_gradient(body_.system->matrix(), {body_.system->preconditioner(), body_.system->factors()}, residual, d,
                       kForcing, std::sqrt(dot(residual, residual)),
                       world_.model->scene.simulation.max_solver_iterations);
    if (whole_.exists()) d -= whole_.part_of(d);
    body_.system->project(d);
    return d;
  }

  /// Backtracks until the energy falls (Armijo); false where it does not.
  bool search_along(const NodeVectors& d, NodeVectors& e, double& energy) {
    constexpr double kSmallest = 1e-4;
    for (double step = 1; step >= kSmallest; step /= 2) {
      const NodeVectors next = e + step * d;
      place(next);
      const double found = energy_at(next);
      if (!(found < energy)) continue;
      e = next;
      energy = found;
      return true;
    }
    place(e);
    return false;
  }

  WorldState& world_;
  Body& body_;
  const BodySnapshot& before_;
  double dt_;
  NodeVectors start_, load_, deforming_;
  Eigen::VectorXd inertia_;
  double damping_share_ = 0;  ///< fraction of β in the contribution of K to the matrix
  WholeMotion whole_;
};

}  // namespace

bool move_nonlinearly(WorldState& world, Body& body, const BodySnapshot& before, const std::vector<Vec3>& external,
                      double dt) {
  const NodeVectors moved = body.system->gather(world.nodes.positions, world.edges.offsets);
  move_without_deforming(world, body, before, external, dt);
  const NodeVectors start = body.system->gather(world.nodes.positions, world.edges.offsets);
  Deformation deformation(world, body, before, start, dt);
  deformation.set_load(external);
  const bool converged = deformation.minimize((moved - start) / dt);
  const NodeVectors& e = deformation.deforming();
  const std::span<const NodeId> nodes = body.system->nodes();
  const std::span<const EdgeId> edges = body.system->edges();
  for (std::size_t i = 0; i < nodes.size(); ++i) world.nodes.velocities[nodes[i]] += e.col(i);
  for (std::size_t i = 0; i < edges.size(); ++i) world.edges.velocities[edges[i]] += e.col(nodes.size() + i);
  restore_angular_momentum(world, body, before);
  return converged;
}

}  // namespace griffith
