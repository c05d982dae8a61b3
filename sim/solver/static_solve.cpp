#include "sim/solver/static_solve.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Householder>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "sim/core/dense_algebra.h"
#include "sim/mesh/topology.h"
#include "sim/solver/linear_solvers.h"
#include "sim/solver/rigid_motion.h"

namespace griffith {
namespace {

// Of at most six columns, which Eigen multiplies without its kernels for large matrices.
template <int kRows, int kMaxRows>
using UpToSix = Eigen::Matrix<double, kRows, Eigen::Dynamic, Eigen::ColMajor, kMaxRows, 6>;
using ModeCombinations = UpToSix<6, 6>;  // one combination of the six modes a column
using NodeMotions = UpToSix<3, 3>;       // what each of them does to a node

/// The forces on a body's nodes in some configuration, and how far it is from equilibrium.
struct Balance {
  std::vector<Vec3> loads;       // per node of the mesh, those that follow it too [N]
  std::vector<Vec3> forces;      // elastic + loads + inertia [N]
  std::vector<Vec3> external;    // loads + inertia [N]
  std::vector<Vec3> residual;    // the forces in the directions that supports leave
  std::vector<Vec3> edges;       // the same of the edges of a quadratic body, per edge of the mesh
  std::vector<Vec3> edge_loads;  // loads on them
  double norm = 0;               // of the residual
  double elastic_energy = 0;     // [J]
};

/// Displacements of the nodes in a step, and of the edges of a quadratic body, per node and edge of the mesh [m].
struct StaticStep {
  std::vector<Vec3> nodes, edges;
};

class StaticSolver {
 public:
  StaticSolver(const StaticProblem& problem, const StaticSettings& settings, std::span<Vec3> positions,
               std::span<ElementState> states);
  StaticReport solve();

 private:
  RigidModes modes_at(NodeId node) const;
  ModeCombinations find_free_motions() const;
  std::vector<NodeConstraint> pin_free_motions() const;
  std::vector<Vec3> relieve(const std::vector<Vec3>& loads) const;
  Balance balance();
  double scale(const Balance& balance) const;
  double rounding_level() const;
  Corners turning_forces(TetId tet) const;
  void add_elastic_forces(TetId tet, std::vector<Vec3>& forces, std::vector<Vec3>& edge_forces) const;
  ElasticSystem make_system();
  StaticStep newton_step(const Balance& now, std::span<const NodeConstraint> constraints);
  void hold_free_motions(std::vector<Vec3>& step) const;
  StaticStep places() const;
  void move(const StaticStep& start, const StaticStep& step, double fraction);
  double energy_gained(const Balance& before, const Balance& after, const StaticStep& step, double fraction) const;
  bool cancelled() const { return settings_.cancelled && settings_.cancelled(); }
  Balance first_step(const Balance& start);
  bool search_line(Balance& now, const StaticStep& step);
  void finish(const Balance& balance);

  const StaticProblem& problem_;
  StaticSettings settings_;
  std::span<Vec3> positions_;
  std::span<ElementState> states_;
  std::vector<NodeId> nodes_;  // the body's
  Vec3 center_;
  double radius_;  // root mean square distance from the center
  ModeCombinations free_motions_;
  std::vector<NodeConstraint> still_;  // the problem's and pins, at no velocity
  std::vector<int> rows_, edge_rows_;
  std::vector<EdgeId> edges_;            // the body's
  std::optional<ElasticSystem> system_;  // once a step is to be made
  StaticReport report_;
};

Vec3 center_of(const std::vector<NodeId>& nodes, std::span<const Vec3> positions) {
  Vec3 sum = Vec3::Zero();
  for (NodeId node : nodes) sum += positions[node];
  return sum / static_cast<double>(nodes.size());
}

double radius_of(const std::vector<NodeId>& nodes, std::span<const Vec3> positions, const Vec3& center) {
  double squares = 0;
  for (NodeId node : nodes) squares += (positions[node] - center).squaredNorm();
  return std::sqrt(squares / static_cast<double>(nodes.size()));
}

StaticSolver::StaticSolver(const StaticProblem& problem, const StaticSettings& settings, std::span<Vec3> positions,
                           std::span<ElementState> states)
    : problem_(problem),
      settings_(settings),
      positions_(positions),
      states_(states),
      nodes_(nodes_of(problem.mesh, problem.tets)),
      center_(center_of(nodes_, positions)),
      radius_(radius_of(nodes_, positions, center_)),
      free_motions_(find_free_motions()),
      still_(pin_free_motions()),
      rows_(positions.size(), -1),
      edge_rows_(problem.edges ? problem.edges->offsets.size() : 0, -1),
      edges_(problem.edges ? edges_of(problem.edges->topology, problem.tets) : std::vector<EdgeId>()) {
  report_.free_motions = static_cast<int>(free_motions_.cols());
}

ElasticSystem StaticSolver::make_system() {
  if (!problem_.edges) return ElasticSystem(problem_.mesh, problem_.tets, still_, rows_);
  return ElasticSystem(problem_.mesh, problem_.edges->topology, problem_.tets, still_, problem_.constraints, rows_,
                       edge_rows_);
}

/// Returns the node's velocity in the three unit translations and three rotations, the latter scaled to lengths alike.
RigidModes StaticSolver::modes_at(NodeId node) const { return rigid_modes((positions_[node] - center_) / radius_); }

/// Returns the rigid motions that move no support in a blocked direction: the null space of sum Rᵀ (I − S) R.
ModeCombinations StaticSolver::find_free_motions() const {
  constexpr double kNegligible = 1e-10;
  Eigen::Matrix<double, 6, 6> blocked = Eigen::Matrix<double, 6, 6>::Zero();
  for (NodeId node : nodes_) {
    if (problem_.constraints[node].is_free()) continue;
    const RigidModes modes = modes_at(node);
    blocked += modes.transpose() * (Mat3::Identity() - problem_.constraints[node].allowed) * modes;
  }
  const SymmetricModes blocking = symmetric_modes(blocked);
  const auto count = (blocking.values.array() <= kNegligible * std::max(1.0, blocking.values[5])).count();
  return blocking.vectors.leftCols(count);
}

/// Returns the Householder reflection that maps a vector of up to six components to the first axis.
UpToSix<Eigen::Dynamic, 6> reflection_onto_first_axis(
    const Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, 6, 1>& v) {
  Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, 5, 1> essential(v.size() - 1);
  double factor = 0, length = 0;
  v.makeHouseholder(essential, factor, length);
  UpToSix<Eigen::Dynamic, 6> reflection = UpToSix<Eigen::Dynamic, 6>::Identity(v.size(), v.size());
  std::array<double, 6> workspace = {};
  reflection.applyHouseholderOnTheLeft(essential, factor, workspace.data());
  return reflection;
}

/// Returns the constraints, at no velocity, with pins that just block the free motions: each time the node and
/// direction that move most. Balanced forces leave no reaction at a pin, so that they only say which of all equal
/// solutions is meant.
std::vector<NodeConstraint> StaticSolver::pin_free_motions() const {
  std::vector<NodeConstraint> constraints(problem_.constraints.begin(), problem_.constraints.end());
  for (NodeConstraint& constraint : constraints) constraint.velocity.setZero();
  ModeCombinations motions = free_motions_;
  while (motions.cols() > 0) {
    const auto size = [&](NodeId node) { return (modes_at(node) * motions).squaredNorm(); };
    const NodeId pinned =
        *std::max_element(nodes_.begin(), nodes_.end(), [&](NodeId a, NodeId b) { return size(a) < size(b); });
    const NodeMotions motion = modes_at(pinned) * motions;
    const Vec3 direction = Eigen::SelfAdjointEigenSolver<Mat3>(motion * motion.transpose()).eigenvectors().col(2);
    constraints[pinned].block(direction, 0);
    // What is left moves the node across the direction alone: the null space of directionᵀ motion.
    const ModeCombinations rotated = motions * reflection_onto_first_axis(motion.transpose() * direction);
    motions = rotated.rightCols(motions.cols() - 1);
  }
  return constraints;
}

/// Returns the loads less the inertia of the free motion that they cause: f − M Z (Zᵀ M Z)⁻¹ Zᵀ f.
std::vector<Vec3> StaticSolver::relieve(const std::vector<Vec3>& loads) const {
  std::vector<Vec3> relieved = loads;
  if (free_motions_.cols() == 0) return relieved;
  Eigen::MatrixXd inertia = Eigen::MatrixXd::Zero(free_motions_.cols(), free_motions_.cols());
  Eigen::VectorXd resultant = Eigen::VectorXd::Zero(free_motions_.cols());
  for (NodeId node : nodes_) {
    const NodeMotions motion = modes_at(node) * free_motions_;
    inertia += problem_.masses[node] * (motion.transpose() * motion);
    resultant += motion.transpose() * loads[node];
  }
  const Eigen::VectorXd acceleration = dense_inverse(inertia) * resultant;
  for (NodeId node : nodes_)
    relieved[node] -= problem_.masses[node] * (modes_at(node) * (free_motions_ * acceleration));
  return relieved;
}

Balance StaticSolver::balance() {
  problem_.evaluate(positions_, states_);
  Balance result;
  result.loads.resize(positions_.size(), Vec3::Zero());
  for (NodeId node : nodes_) result.loads[node] = problem_.loads[node];
  result.edge_loads.resize(edge_rows_.size(), Vec3::Zero());
  if (problem_.edges && !problem_.edges->loads.empty())
    for (const EdgeId edge : edges_) result.edge_loads[edge] = problem_.edges->loads[edge];
  if (problem_.add_follower_loads) problem_.add_follower_loads(positions_, result.loads, result.edge_loads);
  std::vector<Vec3> forces = result.loads, edge_forces = result.edge_loads;
  for (TetId tet : problem_.tets) {
    add_elastic_forces(tet, forces, edge_forces);
    result.elastic_energy += problem_.rest_elements[tet].volume * states_[tet].energy_density;
  }
  result.forces = relieve(forces);
  result.external = result.loads;
  result.residual.resize(forces.size(), Vec3::Zero());
  double squares = 0;
  for (NodeId node : nodes_) {
    result.residual[node] = problem_.constraints[node].allowed * result.forces[node];
    squares += result.residual[node].squaredNorm();
    result.external[node] += result.forces[node] - forces[node];
  }
  result.edges.resize(edge_rows_.size(), Vec3::Zero());
  for (const EdgeId edge : edges_) {
    const auto& [a, b] = problem_.edges->topology.ends[edge];
    const NodeConstraint constraint = constraint_between(problem_.constraints[a], problem_.constraints[b]);
    result.edges[edge] = constraint.allowed * edge_forces[edge];
    squares += result.edges[edge].squaredNorm();
  }
  result.norm = std::sqrt(squares);
  return result;
}

/// Returns V times the turning_traction() at the corners of a linear tet [N].
Corners StaticSolver::turning_forces(TetId tet) const {
  Corners places;
  for (int i = 0; i < 4; ++i) places.col(i) = positions_[problem_.mesh.tets[tet][i]];
  const RestElement& rest = problem_.rest_elements[tet];
  return rest.volume * turning_traction(problem_.law.model, rest, places, states_[tet]) * rest.shape_gradients;
}

void StaticSolver::add_elastic_forces(TetId tet, std::vector<Vec3>& forces, std::vector<Vec3>& edge_forces) const {
  const RestElement& rest = problem_.rest_elements[tet];
  const std::array<NodeId, 4>& corners = problem_.mesh.tets[tet];
  if (!problem_.edges) {
    Corners f = nodal_forces(rest, states_[tet].frame, states_[tet].stress);
    if (problem_.has_stress_free_strains) f -= turning_forces(tet);
    for (int i = 0; i < 4; ++i) forces[corners[i]] += f.col(i);
    return;
  }
  const QuadraticForces f = quadratic_forces(rest, problem_.edges->states[tet]);
  for (int i = 0; i < 4; ++i) forces[corners[i]] += f.corners.col(i);
  for (int i = 0; i < 6; ++i) edge_forces[problem_.edges->topology.of_tet[tet][i]] += f.edges.col(i);
}

/// |loads and reactions|: what the unbalanced forces are small against.
double StaticSolver::scale(const Balance& balance) const {
  double squares = 0;
  for (NodeId node : nodes_) squares += balance.loads[node].squaredNorm();
  for (NodeId node : nodes_)
    squares += (balance.forces[node] - problem_.constraints[node].allowed * balance.forces[node]).squaredNorm();
  return std::sqrt(squares);
}

/// Returns the unbalanced force that the rounding of positions alone makes: strain is known to 1e-16 of position /
/// element size.
double StaticSolver::rounding_level() const {
  return 4 * std::numeric_limits<double>::epsilon() *
         diagonal_product_norm(system_->matrix(), system_->gather(positions_));
}

/// Solves K d = residual with these known displacements; returns d of all nodes.
StaticStep StaticSolver::newton_step(const Balance& now, std::span<const NodeConstraint> constraints) {
  constexpr double kTolerance = 1e-6;
  if (!system_) system_.emplace(make_system());
  const std::vector<double> no_masses(edge_rows_.size(), 0.0);
  system_->assemble(MatrixFactors{0, 1}, problem_.law, problem_.rest_elements, states_, positions_, problem_.masses,
                    no_masses);
  const NodeVectors b = system_->gather(now.residual, now.edges);
  NodeVectors x = NodeVectors::Zero(3, b.cols());
  // Large thin quadratic bodies need many iterations, but a factorization takes longer still.
  constexpr int kManyRows = 3000, kMore = 20;
  const int iterations =
      (system_->edges().empty() || system_->rows() < kManyRows ? 1 : kMore) * settings_.max_iterations;
  const SolveReport linear = system_->solve_projected(constraints, kTolerance, iterations, b, x, settings_.cancelled);
  report_.linear_iterations += linear.iterations;
  if (!linear.converged && !cancelled()) report_.factorizations += system_->solve_directly(constraints, b, x);
  StaticStep step{std::vector<Vec3>(positions_.size(), Vec3::Zero()),
                  std::vector<Vec3>(edge_rows_.size(), Vec3::Zero())};
  for (NodeId node : nodes_) {
    step.nodes[node] = constraints[node].velocity;
    if (rows_[node] >= 0) step.nodes[node] += constraints[node].allowed * x.col(rows_[node]);
  }
  for (const EdgeId edge : edges_)
    if (edge_rows_[edge] >= 0) step.edges[edge] = x.col(edge_rows_[edge]);
  hold_free_motions(step.nodes);
  return step;
}

/// Takes the mean free motion, which pins at single nodes let through, out of a step.
void StaticSolver::hold_free_motions(std::vector<Vec3>& step) const {
  if (free_motions_.cols() == 0) return;
  for (NodeId node : nodes_) step[node] *= problem_.masses[node];
  step = relieve(step);
  for (NodeId node : nodes_) step[node] /= problem_.masses[node];
}

StaticStep StaticSolver::places() const {
  StaticStep now{{positions_.begin(), positions_.end()}, {}};
  if (problem_.edges) now.edges.assign(problem_.edges->offsets.begin(), problem_.edges->offsets.end());
  return now;
}

void StaticSolver::move(const StaticStep& start, const StaticStep& step, double fraction) {
  for (NodeId node : nodes_) positions_[node] = start.nodes[node] + fraction * step.nodes[node];
  for (const EdgeId edge : edges_) problem_.edges->offsets[edge] = start.edges[edge] + fraction * step.edges[edge];
}

/// Returns the growth of the potential energy over a fraction of a step [J]. Loads that follow the surface do work by
/// their mean.
double StaticSolver::energy_gained(const Balance& before, const Balance& after, const StaticStep& step,
                                   double fraction) const {
  double work = 0;
  for (NodeId node : nodes_)
    work += 0.5 * fraction * (before.external[node] + after.external[node]).dot(step.nodes[node]);
  for (const EdgeId edge : edges_)
    work += 0.5 * fraction * (before.edge_loads[edge] + after.edge_loads[edge]).dot(step.edges[edge]);
  return after.elastic_energy - before.elastic_energy - work;
}

/// Halves the step until the energy decreases enough (Armijo 1966) or the imbalance of forces decreases. Returns false
/// if neither happens.
bool StaticSolver::search_line(Balance& now, const StaticStep& step) {
  constexpr double kSufficientFraction = 1e-4;
  constexpr int kMaxHalvings = 12;
  const StaticStep start = places();
  double slope = 0;
  for (NodeId node : nodes_) slope += now.residual[node].dot(step.nodes[node]);
  for (const EdgeId edge : edges_) slope += now.edges[edge].dot(step.edges[edge]);
  double fraction = 1;
  for (int i = 0; i < kMaxHalvings; ++i, fraction /= 2) {
    move(start, step, fraction);
    Balance next = balance();
    const bool closer = next.norm <= (1 - kSufficientFraction * fraction) * now.norm;
    const bool lower = slope > 0 && energy_gained(now, next, step, fraction) <= -kSufficientFraction * fraction * slope;
    if (!closer && !lower) continue;
    now = std::move(next);
    return true;
  }
  move(start, step, 0);
  now = balance();
  return false;
}

/// Makes the prescribed displacements, with the linear response of all other nodes to them.
Balance StaticSolver::first_step(const Balance& start) {
  std::vector<NodeConstraint> moving = still_;
  for (NodeId node : nodes_) moving[node].velocity = problem_.constraints[node].velocity;
  move(places(), newton_step(start, moving), 1);
  report_.newton_steps = 1;
  return balance();
}

StaticReport StaticSolver::solve() {
  Balance now = balance();
  const bool moves =
      std::ranges::any_of(nodes_, [&](NodeId node) { return !problem_.constraints[node].velocity.isZero(0); });
  report_.converged = !moves && now.norm <= settings_.relative_residual * scale(now);
  if (!report_.converged) {
    now = first_step(now);
    const auto target = [&] { return std::max(settings_.relative_residual * scale(now), rounding_level()); };
    while (now.norm > target() && report_.newton_steps < settings_.max_newton_steps && !cancelled()) {
      ++report_.newton_steps;
      if (!search_line(now, newton_step(now, still_))) break;
    }
    report_.converged = now.norm <= target();
  }
  finish(now);
  return report_;
}

void StaticSolver::finish(const Balance& now) {
  const double reference = scale(now);
  report_.relative_residual = reference > 0 ? now.norm / reference : 0;
  for (NodeId node : nodes_) {
    const NodeConstraint& constraint = problem_.constraints[node];
    if (constraint.is_free()) continue;
    report_.supports.push_back(node);
    report_.reaction_forces.push_back(constraint.allowed * now.forces[node] - now.forces[node]);
  }
  const std::vector<Vec3> relieved = relieve(now.loads);
  double accelerating = 0, applied = 0;
  for (NodeId node : nodes_) {
    accelerating += (relieved[node] - now.loads[node]).squaredNorm();
    applied += now.loads[node].squaredNorm();
  }
  report_.unbalanced_fraction = applied > 0 ? std::sqrt(accelerating / applied) : 0;
}

}  // namespace

StaticReport solve_static(const StaticProblem& problem, const StaticSettings& settings, std::span<Vec3> positions,
                          std::span<ElementState> states) {
  return StaticSolver(problem, settings, positions, states).solve();
}

}  // namespace griffith
