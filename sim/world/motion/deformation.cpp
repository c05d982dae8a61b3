#include "sim/world/motion/deformation.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "sim/core/parallel.h"
#include "sim/solver/conjugate_gradient.h"
#include "sim/world/bodies/effective_law.h"
#include "sim/world/contact/group_builder.h"
#include "sim/world/motion/elastic_phase.h"
#include "sim/world/state/corners.h"

namespace griffith {

Deformation::Deformation(WorldState& world, Body& body, const BodySnapshot& before, NodeVectors start, double dt,
                         bool with_tangents)
    : world_(world), body_(body), before_(before), dt_(dt), start_(std::move(start)) {
  const Material& material = world.material_of(body);
  inertia_ = masses() * (1 + dt * material.mass_damping);
  damping_share_ = material.stiffness_damping / (dt + material.stiffness_damping);
  whole_ = whole_motion(world, body, dt);
  forces_.resize(world.nodes.positions.size(), Vec3::Zero());
  has_tangents_ =
      with_tangents && body.edges.empty() && !material.yield_strength &&
      std::ranges::all_of(body.tets, [&](TetId tet) { return world.elements.stress_free_strain(tet).isZero(0); });
  if (has_tangents_) first_matrix_ = body.system->matrix();
}

void Deformation::set_load(const std::vector<Vec3>& external, const NodeVectors& carried) {
  const SubstepStart& start = world_.scratch.substep_start;
  const ElasticSystem& system = *body_.system;
  external_load_ = system.gather(start.velocities, start.edge_velocities) * masses().asDiagonal();
  external_load_ += dt_ * system.gather(external, world_.scratch.edge_loads);
  if (!whole_.exists()) external_load_ -= carried * inertia_.asDiagonal();
  take_contacts();
}

void Deformation::take_contacts() {
  load_ = external_load_ + body_.system->gather(world_.scratch.contact_impulses);
  remove_whole(load_);
}

void Deformation::place(const NodeVectors& e) {
  restore_plastic_strains(world_, body_, before_);
  const NodeVectors places = start_ + dt_ * e;
  const std::span<const NodeId> nodes = body_.system->nodes();
  const std::span<const EdgeId> edges = body_.system->edges();
  for (std::size_t i = 0; i < nodes.size(); ++i) world_.nodes.positions[nodes[i]] = places.col(i);
  for (std::size_t i = 0; i < edges.size(); ++i) world_.edges.offsets[edges[i]] = places.col(nodes.size() + i);
  update_elements(world_, body_);
  deforming_ = e;
}

/// Assembles the matrix of the step at the present positions. Elements may soften as they buckle, as long as their
/// inertia keeps the matrix positive definite.
void Deformation::assemble() {
  if (!has_tangents_) return assemble_system(world_, body_, dt_);
  constexpr double kOfInertia = 0.9;
  const ElasticLaw law = effective_elastic_law(world_, body_);
  const ImplicitStep step = implicit_step(world_, body_, dt_);
  const MatrixFactors factors = matrix_factors(step);
  const double inertia = kOfInertia * factors.mass * world_.material_of(body_).density / (4 * factors.stiffness);
  parallel_for(static_cast<int>(body_.tets.size()), 256, [&](int begin, int end) {
    for (const TetId tet : std::span(body_.tets).subspan(begin, end - begin)) {
      const RestElement& rest = world_.elements.rest_elements[tet];
      const double least = -inertia / rest.shape_gradients.squaredNorm();
      world_.scratch.tangents[tet] =
          tangent_stiffness(law, rest, corners_of(world_.mesh, tet, world_.nodes.positions), least);
    }
  });
  body_.system->assemble(step, world_.elements.rest_elements, world_.scratch.tangents, world_.nodes.positions,
                         world_.nodes.masses);
}

bool Deformation::minimize(NodeVectors e) {
  constexpr int kMaxNewtonSteps = 30;
  constexpr double kForcing = 0.01;
  choose_start(e);
  for (int step = 0; step < kMaxNewtonSteps; ++step) {
    assemble();
    const auto [left, all] = balance();
    if (left <= world_.model->scene.simulation.relative_residual * all) return true;
    if (search_along(direction(residual(), kForcing)) == 0) return false;
  }
  return false;
}

NodeVectors Deformation::without_contacts(const NodeVectors& e) {
  constexpr double kForcing = 1e-4;
  place(e);
  assemble();
  NodeVectors left = external_load_ + elastic_impulses() - resistance(e);
  project(left);
  return e + direction(left, kForcing);
}

Deformation::Balance Deformation::balance() const {
  const NodeVectors forces = elastic_impulses(), left = residual();
  return {std::sqrt(dot(left, left)), std::sqrt(dot(forces, forces)) + std::sqrt(dot(load_, load_))};
}

Eigen::VectorXd Deformation::masses() const {
  return body_.system->gather_masses(world_.nodes.masses, world_.edges.masses);
}

void Deformation::remove_whole(NodeVectors& impulses) const {
  if (whole_.exists()) impulses -= whole_.momentum_of(impulses);
}

void Deformation::project(NodeVectors& impulses) const {
  remove_whole(impulses);
  body_.system->project(impulses);
}

/// Begins with the guess, or from rest where that has less energy.
void Deformation::choose_start(const NodeVectors& guess) {
  const NodeVectors rest = NodeVectors::Zero(3, guess.cols());
  place(rest);
  const double at_rest = energy();
  place(guess);
  if (energy() > at_rest) place(rest);
}

/// Returns h f of the elastic forces at the present positions.
NodeVectors Deformation::elastic_impulses() const {
  for (const NodeId node : body_.nodes) forces_[node].setZero();
  add_elastic_forces(world_, body_, forces_, world_.scratch);
  return dt_ * body_.system->gather(forces_, world_.scratch.edge_forces);
}

/// Returns the resistance of mass and damping to the velocities: M e + h β K e.
NodeVectors Deformation::resistance(const NodeVectors& e) const {
  const NodeVectors by_mass = e * inertia_.asDiagonal();
  if (damping_share_ == 0) return by_mass;
  NodeVectors product;
  multiply(has_tangents_ ? first_matrix_ : body_.system->matrix(), e, product);
  return by_mass + damping_share_ * (product - by_mass);
}

double Deformation::energy() const {
  return elastic_energy(world_, body_) + 0.5 * dot(deforming_, resistance(deforming_)) - dot(deforming_, load_);
}

NodeVectors Deformation::residual() const {
  NodeVectors left = load_ + elastic_impulses() - resistance(deforming_);
  project(left);
  return left;
}

NodeVectors Deformation::direction(const NodeVectors& residual, double forcing) const {
  NodeVectors d = NodeVectors::Zero(3, residual.cols());
  conjugate_gradient(body_.system->matrix(), {body_.system->preconditioner(), body_.system->factors()}, residual, d,
                     forcing, std::sqrt(dot(residual, residual)), world_.model->scene.simulation.max_solver_iterations);
  if (whole_.exists()) d -= whole_.part_of(d);
  body_.system->project(d);
  return d;
}

/// Returns det F of the body's linear tets, where they resist compaction.
std::vector<double> Deformation::volume_ratios() const {
  std::vector<double> ratios;
  if (effective_elastic_law(world_, body_).compaction == 0) return ratios;
  for (const TetId tet : body_.tets)
    ratios.push_back(
        deformation_gradient(world_.elements.rest_elements[tet], corners_of(world_.mesh, tet, world_.nodes.positions))
            .determinant());
  return ratios;
}

namespace {

/// True if a tet loses more of its volume than Newton's method can foresee: its energy grows by the inverse square.
bool flattens(const std::vector<double>& before, const std::vector<double>& after) {
  constexpr double kLeft = 0.2;
  for (std::size_t i = 0; i < before.size(); ++i)
    if (before[i] > 0 && after[i] < kLeft * std::min(1.0, before[i])) return true;
  return false;
}

}  // namespace

double Deformation::search_along(const NodeVectors& d) {
  constexpr double kSmallest = 1e-4, kRounding = 1e-12;
  const NodeVectors first = deforming_;
  const double now = energy();
  const double rounding = has_tangents_ ? kRounding * (std::abs(now) + std::abs(dot(deforming_, load_))) : 0;
  const double least = now + rounding;
  const std::vector<double> volumes = volume_ratios();
  for (double step = 1; step >= kSmallest; step /= 2) {
    place(first + step * d);
    if (!flattens(volumes, volume_ratios()) && energy() < least) return step;
  }
  place(first);
  return 0;
}

}  // namespace griffith
