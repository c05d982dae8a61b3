#include "sim/solver/elastic_system.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "sim/mesh/topology.h"
#include "sim/solver/linear_solvers.h"
#include "sim/solver/pivot.h"
#include "sim/solver/whole_motion.h"

namespace griffith {
namespace {

constexpr int kFirstEdgeColumn = 1 << 30;

/// Small aggregates save iterations, many of them make the coarse matrix dear: these sizes balance the two.
int aggregate_size(int rows) {
  constexpr int kSmallest = 20, kMaxAggregates = 600;
  return std::max(kSmallest, rows / kMaxAggregates);
}

/// Numbers the nodes that are not held, and returns them.
std::vector<NodeId> number_rows(std::span<const NodeId> body_nodes, std::span<const NodeConstraint> constraints,
                                std::span<int> row_of_node) {
  std::vector<NodeId> numbered;
  numbered.reserve(body_nodes.size());
  for (NodeId node : body_nodes) {
    row_of_node[node] = constraints[node].is_held() ? -1 : static_cast<int>(numbered.size());
    if (!constraints[node].is_held()) numbered.push_back(node);
  }
  return numbered;
}

/// Adds the centrifugal impulses on the shape, in a frame that rotates with the body: h·m ω×(a×ω) for a node at arm a.
void add_centrifugal_impulses(const WholeMotion& whole, const Vec3& spin, double dt, NodeVectors& impulses) {
  for (Eigen::Index row = 0; row < whole.masses.size(); ++row) {
    const Vec3 arm = whole.arms.col(row);
    impulses.col(row) += dt * whole.masses[row] * spin.cross(arm.cross(spin));
  }
}

/// Solves A x = b where the motion as a whole follows from momentum balance alone, so that only the deformation is
/// solved for: no residual can slow a fall or a swing, and convergence is relative to what is elastic. It is solved for
/// in axes that move along, in which that motion strains nothing: the stiffness in A would resist its displacement
/// along tangents. `masses`: per row [kg].
SolveReport solve_beside(const BlockSparseMatrix& a, const Preconditioning& preconditioner, const ImplicitStep& step,
                         const Eigen::VectorXd& masses, const WholeMotion& whole, const NodeVectors& b,
                         NodeVectors& x) {
  const Eigen::VectorXd damped_masses = masses * (1 + step.dt * step.mass_damping);
  const NodeVectors rigid = whole.part_of(b * damped_masses.cwiseInverse().asDiagonal());
  NodeVectors elastic = b - rigid * damped_masses.asDiagonal();
  add_centrifugal_impulses(whole, whole.spin_of(rigid), step.dt, elastic);
  elastic -= whole.momentum_of(elastic);

  // Below the rounding errors of elastic forces there is only noise to solve for.
  const double noise = 4 * std::numeric_limits<double>::epsilon() * diagonal_product_norm(a, rigid);
  const double scale = std::max(std::sqrt(dot(elastic, elastic)), noise / step.relative_residual);
  x -= whole.part_of(x);
  const SolveReport report =
      conjugate_gradient(a, preconditioner, elastic, x, step.relative_residual, scale, step.max_iterations, {}, &whole);
  x += rigid;
  return report;
}

/// Lets a row move in the allowed directions alone; scaled, the rest keeps the matrix positive definite.
void project_row(BlockSparseMatrix& a, int row, const Mat3& allowed) {
  Mat3& diagonal = a.blocks[a.slot(row, row)];
  const double scale = diagonal.trace() / 3;
  for (int k = a.row_starts[row]; k < a.row_starts[row + 1]; ++k) {
    Mat3& transposed = a.blocks[a.slot(a.columns[k], row)];
    a.blocks[k] = allowed * a.blocks[k];
    transposed = transposed * allowed;
  }
  diagonal += scale * (Mat3::Identity() - allowed);
}

}  // namespace

ElasticSystem::ElasticSystem(const TetMesh& mesh, std::span<const TetId> tets,
                             std::span<const NodeConstraint> constraints, std::span<int> row_of_node) {
  const std::vector<NodeId> body_nodes = nodes_of(mesh, tets);
  ElementRows& rows = rows_.edit();
  for (NodeId node : number_rows(body_nodes, constraints, row_of_node)) rows.add(mesh, node, row_of_node);
  rows.allocate();
  rebuild_support_rows(mesh, body_nodes, constraints, row_of_node);
  preconditioner_.emplace(RigidModePreconditioner(matrix(), matrix().rows(), aggregate_size(matrix().rows())));
}

ElasticSystem::ElasticSystem(const TetMesh& mesh, const TetEdges& topology, std::span<const TetId> tets,
                             std::span<const NodeConstraint> constraints, std::span<const NodeConstraint> of_ends,
                             std::span<int> row_of_node, std::span<int> row_of_edge) {
  const std::vector<NodeId> body_nodes = nodes_of(mesh, tets),
                            unknown = number_rows(body_nodes, constraints, row_of_node);
  const auto node_rows = static_cast<int>(unknown.size());
  std::vector<EdgeId> unknown_edges;
  std::vector<NodeConstraint> edge_constraints;
  for (const EdgeId edge : edges_of(topology, tets)) {
    const auto& [a, b] = topology.ends[edge];
    const NodeConstraint constraint = constraint_between(of_ends[a], of_ends[b]);
    row_of_edge[edge] = constraint.is_held() ? -1 : node_rows + static_cast<int>(unknown_edges.size());
    if (constraint.is_held()) continue;
    unknown_edges.push_back(edge);
    edge_constraints.push_back(constraint);
  }
  const QuadraticColumns columns{[&](NodeId node) { return row_of_node[node]; },
                                 [&](EdgeId edge) { return row_of_edge[edge]; }};
  ElementRows& rows = rows_.edit();
  for (const NodeId node : unknown) rows.add_quadratic(mesh, topology, node, columns);
  for (const EdgeId edge : unknown_edges) rows.add_quadratic(mesh, topology, edge, columns);
  rows.allocate();
  rebuild_support_rows(mesh, topology, body_nodes, constraints, row_of_node, row_of_edge);
  for (std::size_t i = 0; i < unknown_edges.size(); ++i)
    if (!edge_constraints[i].is_free())
      sliding_.push_back({row_of_edge[unknown_edges[i]], edge_constraints[i].allowed});
  EliminationPlan plan = plan_elimination(matrix());
  const bool is_factored = FactorPreconditioner::is_affordable(plan);
  if (is_factored) factors_.emplace(std::move(plan), std::vector<TetId>(tets.begin(), tets.end()));
  preconditioner_.emplace(RigidModePreconditioner(matrix(), is_factored ? 0 : node_rows, aggregate_size(node_rows)));
}

std::size_t ElasticSystem::memory(const ElasticSystem* beside) const {
  const auto size_of = [&](auto part) {
    const auto& mine = this->*part;
    const bool is_shared = beside && mine && (beside->*part) && mine->shares_with(*(beside->*part));
    return !mine || is_shared ? 0 : (*mine)->memory();
  };
  std::size_t size = sizeof(*this);
  if (!beside || !rows_.shares_with(beside->rows_)) size += rows_->memory();
  if (!beside || !support_rows_.shares_with(beside->support_rows_)) size += support_rows_->memory();
  if (factors_ && !(beside && beside->factors_ && factors_->shares_with(*beside->factors_))) size += factors_->memory();
  return size + size_of(&ElasticSystem::inputs_) + size_of(&ElasticSystem::preconditioner_);
}

void ElasticSystem::patch(const TetMesh& mesh, std::span<const NodeId> body_nodes,
                          std::span<const NodeConstraint> constraints, std::span<int> row_of_node) {
  const std::vector<NodeId> unknown = number_rows(body_nodes, constraints, row_of_node);
  const std::vector<int> previous_rows = rows_.edit().patch(mesh, unknown, row_of_node);
  rebuild_support_rows(mesh, body_nodes, constraints, row_of_node);
  preconditioner_->edit().patch(matrix(), previous_rows, aggregate_size(matrix().rows()));
  inputs_.reset();
}

void ElasticSystem::rebuild_support_rows(const TetMesh& mesh, std::span<const NodeId> body_nodes,
                                         std::span<const NodeConstraint> constraints,
                                         std::span<const int> row_of_node) {
  sliding_.clear();
  ElementRows support_rows;
  row_of_support_column_.clear();
  for (NodeId node : body_nodes) {
    if (constraints[node].is_free()) continue;
    if (row_of_node[node] >= 0) sliding_.push_back({row_of_node[node], constraints[node].allowed});
    support_rows.add(mesh, node, {});
  }
  support_rows.allocate();
  support_rows_ = CopyOnWrite(std::move(support_rows));
  for (int column : support_rows_->matrix.columns) row_of_support_column_.push_back(row_of_node[column]);
  reactions_.assign(supports().size(), Vec3::Zero());
}

void ElasticSystem::rebuild_support_rows(const TetMesh& mesh, const TetEdges& topology,
                                         std::span<const NodeId> body_nodes,
                                         std::span<const NodeConstraint> constraints, std::span<const int> row_of_node,
                                         std::span<const int> row_of_edge) {
  const QuadraticColumns columns{[](NodeId node) { return node.index(); },
                                 [](EdgeId edge) { return kFirstEdgeColumn + edge.index(); }};
  ElementRows& support_rows = support_rows_.edit();
  for (const NodeId node : body_nodes) {
    if (constraints[node].is_free()) continue;
    if (row_of_node[node] >= 0) sliding_.push_back({row_of_node[node], constraints[node].allowed});
    support_rows.add_quadratic(mesh, topology, node, columns);
  }
  support_rows.allocate();
  for (const int column : support_rows.matrix.columns)
    row_of_support_column_.push_back(column < kFirstEdgeColumn ? row_of_node[column]
                                                               : row_of_edge[column - kFirstEdgeColumn]);
  reactions_.assign(supports().size(), Vec3::Zero());
}

void ElasticSystem::assemble(const ImplicitStep& step, const ElasticLaw& law,
                             std::span<const RestElement> rest_elements, std::span<const ElementState> states,
                             std::span<const Vec3> positions, std::span<const double> masses,
                             std::span<const double> edge_masses) {
  assemble(matrix_factors(step), law, rest_elements, states, positions, masses, edge_masses);
}

void ElasticSystem::assemble(const ImplicitStep& step, std::span<const RestElement> rest_elements,
                             std::span<const TangentStiffness> tangents, std::span<const Vec3> positions,
                             std::span<const double> masses) {
  inputs_.reset();
  rows_.edit().assemble(matrix_factors(step), rest_elements, tangents, masses);
  support_rows_.edit().assemble(matrix_factors(step), rest_elements, tangents, masses);
  project_sliding_rows();
  preconditioner_->edit().update(matrix(), gather(positions));
}

void ElasticSystem::assemble(const MatrixFactors& factors, const ElasticLaw& law,
                             std::span<const RestElement> rest_elements, std::span<const ElementState> states,
                             std::span<const Vec3> positions, std::span<const double> masses,
                             std::span<const double> edge_masses) {
  if (!inputs_) inputs_.emplace(AssemblyInputs(rows_, support_rows_));
  if ((*inputs_)->still_hold(factors, law, states, masses)) return;
  inputs_->edit().record(factors, law, states, masses);
  rows_.edit().assemble(factors, law, rest_elements, states, masses, edge_masses);
  support_rows_.edit().assemble(factors, law, rest_elements, states, masses, edge_masses);
  project_sliding_rows();
  preconditioner_->edit().update(matrix(), gather(positions));
  if (factors_) factors_->update(matrix(), factors, states);
}

void ElasticSystem::project_sliding_rows() {
  for (const SlidingRow& sliding : sliding_) project_row(rows_.edit().matrix, sliding.row, sliding.allowed);
}

NodeVectors ElasticSystem::gather(std::span<const Vec3> values, std::span<const Vec3> of_edges) const {
  NodeVectors gathered(3, rows());
  const std::size_t count = nodes().size();
  for (std::size_t row = 0; row < count; ++row) gathered.col(row) = values[nodes()[row]];
  for (std::size_t i = 0; i < edges().size(); ++i)
    gathered.col(count + i) = of_edges.empty() ? Vec3(Vec3::Zero()) : of_edges[edges()[i]];
  return gathered;
}

SolveReport ElasticSystem::solve(const ImplicitStep& step, std::span<const Vec3> positions,
                                 std::span<const Vec3> forces, std::span<const double> masses,
                                 std::span<const NodeConstraint> constraints, std::span<Vec3> velocities,
                                 const EdgeMotion& of_edges) {
  const int count = static_cast<int>(nodes().size());
  const Eigen::VectorXd mass = gather_masses(masses, of_edges.masses);
  const NodeVectors places = gather(positions, of_edges.offsets);
  NodeVectors x = gather(velocities, of_edges.velocities);
  NodeVectors b = x * mass.asDiagonal() + step.dt * gather(forces, of_edges.forces);
  for (std::size_t i = 0; i < supports().size(); ++i)
    reactions_[i] = -masses[supports()[i]] * velocities[supports()[i]] - step.dt * forces[supports()[i]];

  SolveReport report;
  if (is_free()) {
    const WholeMotion whole = free_motion(places, mass.head(count));
    report = solve_beside(rows_->matrix, preconditioning(), step, mass, whole, b, x);
  } else if (const std::optional<Pivot> pivot = pivot_of(supports(), constraints, positions)) {
    const WholeMotion whole = swinging_motion(places, mass.head(count), *pivot);
    project(b);
    report = solve_beside(rows_->matrix, preconditioning(), step, mass, whole, b, x);
    project(x);
  } else {
    report = solve_carried(step, constraints, mass, b, x);
  }
  if (factors_) factors_->count_iterations(report.iterations);
  for (int row = 0; row < count; ++row) velocities[nodes()[row]] = x.col(row);
  for (std::size_t i = 0; i < edges().size(); ++i) of_edges.velocities[edges()[i]] = x.col(count + i);
  for (NodeId node : supports())
    velocities[node] = constraints[node].velocity + constraints[node].allowed * velocities[node];
  balance_supports(step.dt, constraints, velocities, of_edges.velocities);
  return report;
}

void ElasticSystem::add_reactions(double dt, std::span<const Vec3> impulses,
                                  std::span<const NodeConstraint> constraints, const NodeVectors& change,
                                  std::span<Vec3> reactions) const {
  const BlockSparseMatrix& a = support_rows_->matrix;
  for (int support = 0; support < a.rows(); ++support) {
    Vec3 impulse = -impulses[supports()[support]];
    for (int k = a.row_starts[support]; k < a.row_starts[support + 1]; ++k)
      if (const int row = row_of_support_column_[k]; row >= 0) impulse += a.blocks[k] * change.col(row);
    reactions[supports()[support]] += (impulse - constraints[supports()[support]].allowed * impulse) / dt;
  }
}

Eigen::VectorXd ElasticSystem::gather_masses(std::span<const double> masses, std::span<const double> of_edges) const {
  Eigen::VectorXd gathered(rows());
  const std::size_t count = nodes().size();
  for (std::size_t row = 0; row < count; ++row) gathered[row] = masses[nodes()[row]];
  for (std::size_t i = 0; i < edges().size(); ++i) gathered[count + i] = of_edges.empty() ? 0 : of_edges[edges()[i]];
  return gathered;
}

void ElasticSystem::project(NodeVectors& x) const {
  for (const SlidingRow& sliding : sliding_) x.col(sliding.row) = Vec3(sliding.allowed * x.col(sliding.row));
}

void ElasticSystem::project_right_hand_side(std::span<const NodeConstraint> constraints, NodeVectors& b,
                                            const Vec3& carried) const {
  // A is symmetric, so the rows of the supports hold the columns that meet the known velocities.
  const BlockSparseMatrix& a = support_rows_->matrix;
  for (int support = 0; support < a.rows(); ++support) {
    const NodeConstraint& constraint = constraints[supports()[support]];
    const Vec3 known = constraint.velocity - (carried - constraint.allowed * carried);
    if (known.isZero(0)) continue;
    for (int k = a.row_starts[support]; k < a.row_starts[support + 1]; ++k)
      if (const int row = row_of_support_column_[k]; row >= 0) b.col(row) -= a.blocks[k].transpose() * known;
  }
  project(b);
}

SolveReport ElasticSystem::solve_projected(std::span<const NodeConstraint> constraints, double relative_residual,
                                           int max_iterations, NodeVectors b, NodeVectors& x,
                                           const std::function<bool()>& cancelled) {
  if (rows() == 0) return {};
  project_right_hand_side(constraints, b);
  const SolveReport report = solve_rows(b, x, relative_residual, max_iterations, cancelled);
  if (factors_) factors_->count_iterations(report.iterations);
  return report;
}

SolveReport ElasticSystem::solve_rows(const NodeVectors& b, NodeVectors& x, double relative_residual,
                                      int max_iterations, const std::function<bool()>& cancelled) const {
  project(x);
  return conjugate_gradient(rows_->matrix, preconditioning(), b, x, relative_residual, std::sqrt(dot(b, b)),
                            max_iterations, cancelled);
}

SolveReport ElasticSystem::solve_carried(const ImplicitStep& step, std::span<const NodeConstraint> constraints,
                                         const Eigen::VectorXd& masses, NodeVectors b, NodeVectors& x) const {
  if (rows() == 0) return {};
  const Vec3 carried = common_velocity(supports(), constraints);
  const auto count = static_cast<Eigen::Index>(nodes().size());
  const Eigen::VectorXd resisting = (1 + step.dt * step.mass_damping) * masses.head(count);
  b.leftCols(count) -= carried * resisting.transpose();
  x.leftCols(count).colwise() -= carried;
  project_right_hand_side(constraints, b, carried);
  const SolveReport report = solve_rows(b, x, step.relative_residual, step.max_iterations);
  x.leftCols(count).colwise() += carried;
  project(x);
  return report;
}

bool ElasticSystem::solve_directly(std::span<const NodeConstraint> constraints, NodeVectors b, NodeVectors& x) const {
  project_right_hand_side(constraints, b);
  return direct_solve(rows_->matrix, b, x);
}

void ElasticSystem::balance_supports(double dt, std::span<const NodeConstraint> constraints,
                                     std::span<const Vec3> velocities, std::span<const Vec3> edge_velocities) {
  const BlockSparseMatrix& a = support_rows_->matrix;
  const auto velocity_of = [&](int column) {
    return column < kFirstEdgeColumn ? velocities[column] : edge_velocities[column - kFirstEdgeColumn];
  };
  for (int support = 0; support < a.rows(); ++support) {
    Vec3 impulse = reactions_[support];
    for (int k = a.row_starts[support]; k < a.row_starts[support + 1]; ++k)
      impulse += a.blocks[k] * velocity_of(a.columns[k]);
    reactions_[support] = (impulse - constraints[supports()[support]].allowed * impulse) / dt;
  }
}

}  // namespace griffith
