#include "sim/solver/preconditioner.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <utility>

#include "sim/core/parallel.h"
#include "sim/solver/aggregates.h"
#include "sim/solver/rigid_motion.h"

namespace griffith {
namespace {

/// The factors of a matrix this close do as well: where little moves, most of the set-up is saved.
constexpr double kSameMatrix = 1e-3;

/// Returns the neighbors of each aggregate with a higher number, and itself, in another numbering.
std::vector<std::vector<int>> renumbered(const std::vector<std::vector<int>>& neighbors,
                                         const std::vector<int>& numbers) {
  std::vector<std::vector<int>> result(neighbors.size());
  for (std::size_t a = 0; a < neighbors.size(); ++a)
    for (const int other : neighbors[a]) {
      const auto [low, high] = std::minmax(numbers[a], numbers[other]);
      result[low].push_back(high);
    }
  for (std::vector<int>& rows : result) std::ranges::sort(rows);
  return result;
}

Vec3 vector_of(const NodeVectors& vectors, int node) { return vectors.col(node); }
Vec3 vector_of(const SingleVectors& vectors, int node) {
  const simd::Quad& v = vectors[node];
  return Eigen::Vector3f(v[0], v[1], v[2]).cast<double>();
}

simd::Quad single(const Vec3& v) {
  return simd::Quad{static_cast<float>(v[0]), static_cast<float>(v[1]), static_cast<float>(v[2]), 0};
}

/// turn × arm, of the first three lanes.
simd::Quad cross(simd::Quad turn, simd::Quad arm) {
  const simd::Quad turned = __builtin_shufflevector(turn, turn, 1, 2, 0, 3);
  const simd::Quad moved = __builtin_shufflevector(arm, arm, 1, 2, 0, 3);
  const simd::Quad product = turn * moved - turned * arm;
  return __builtin_shufflevector(product, product, 1, 2, 0, 3);
}

/// Returns the pattern of the first `count` rows and columns.
BlockSparseMatrix leading_pattern(const BlockSparseMatrix& matrix, int count) {
  BlockSparseMatrix leading;
  for (int row = 0; row < count; ++row) {
    for (int k = matrix.row_starts[row]; k < matrix.row_starts[row + 1] && matrix.columns[k] < count; ++k)
      leading.columns.push_back(matrix.columns[k]);
    leading.row_starts.push_back(static_cast<int>(leading.columns.size()));
  }
  return leading;
}

}  // namespace

const Eigen::SparseMatrix<double>* CopyableCholesky::factor(const Eigen::SparseMatrix<double>& matrix) {
  if (!solver_) {
    solver_ = std::make_unique<Solver>();
    solver_->analyzePattern(matrix);
  }
  solver_->factorize(matrix);
  if (solver_->info() != Eigen::Success) return nullptr;
  return &solver_->matrixL().nestedExpression();
}

RigidModePreconditioner::RigidModePreconditioner(const BlockSparseMatrix& matrix, int node_rows, int aggregate_size)
    : aggregates_(
          aggregate_rows(node_rows < matrix.rows() ? leading_pattern(matrix, node_rows) : matrix, aggregate_size)) {
  collect_members();
  build_coarse_pattern(matrix);
}

std::size_t RigidModePreconditioner::memory() const {
  return aggregates_.size() * (2 * sizeof(int) + 2 * sizeof(Vec3) + sizeof(Mat3)) + coarse_slots_.size() * sizeof(int) +
         static_cast<std::size_t>(coarse_.nonZeros()) * (2 * sizeof(double) + sizeof(int)) + triangle_.memory();
}

void RigidModePreconditioner::patch(const BlockSparseMatrix& matrix, const std::vector<int>& previous_rows,
                                    int aggregate_size) {
  std::vector<int> aggregates(matrix.rows());
  for (int row = 0; row < matrix.rows(); ++row)
    aggregates[row] = previous_rows[row] < 0 ? -1 : aggregates_[previous_rows[row]];
  aggregates_ = patch_aggregates(matrix, aggregate_size, std::move(aggregates));
  is_patched_ = true;
  collect_members();
  build_coarse_pattern(matrix);
}

void RigidModePreconditioner::collect_members() {
  members_.clear();
  for (std::size_t node = 0; node < aggregates_.size(); ++node) {
    if (aggregates_[node] >= aggregate_count()) members_.resize(aggregates_[node] + 1);
    members_[aggregates_[node]].push_back(static_cast<int>(node));
  }
}

NodeVectors RigidModePreconditioner::arms(const NodeVectors& positions) const {
  NodeVectors arms(3, node_rows());
  for (const std::vector<int>& nodes : members_) {
    Vec3 center = Vec3::Zero();
    for (int node : nodes) center += positions.col(node);
    center /= static_cast<double>(nodes.size());
    for (int node : nodes) arms.col(node) = positions.col(node) - center;
  }
  if (const double square = arms.squaredNorm(); square > 0) arms *= std::sqrt(arms.cols() / square);
  return arms;
}

RigidModePreconditioner::Fingerprint RigidModePreconditioner::fingerprint(const BlockSparseMatrix& matrix,
                                                                          const NodeVectors& positions) const {
  Fingerprint found{arms(positions), {}, {}};
  found.inverse_diagonal.resize(matrix.rows());
  parallel_for(matrix.rows(), 1024, [&](int begin, int end) {
    for (int node = begin; node < end; ++node)
      found.inverse_diagonal[node] = matrix.blocks[matrix.slot(node, node)].inverse();
  });
  multiply(matrix, NodeVectors::Ones(3, matrix.rows()), found.pushes);
  return found;
}

bool RigidModePreconditioner::is_close(const Fingerprint& a, const Fingerprint& b) {
  constexpr double kSquare = kSameMatrix * kSameMatrix;
  if (a.inverse_diagonal.size() != b.inverse_diagonal.size()) return false;
  if (!((a.arms - b.arms).squaredNorm() <= kSquare * a.arms.squaredNorm())) return false;
  if (!((a.pushes - b.pushes).squaredNorm() <= kSquare * a.pushes.squaredNorm())) return false;
  double change = 0, size = 0;
  for (std::size_t node = 0; node < a.inverse_diagonal.size(); ++node) {
    change += (a.inverse_diagonal[node] - b.inverse_diagonal[node]).squaredNorm();
    size += a.inverse_diagonal[node].squaredNorm();
  }
  return change <= kSquare * size;
}

void RigidModePreconditioner::update(const BlockSparseMatrix& matrix, const NodeVectors& positions) {
  Fingerprint found = fingerprint(matrix, positions);
  if (!is_patched_ && is_close(found, known_)) return;
  known_ = std::move(found);
  is_patched_ = false;
  if (members_.empty()) return void(triangle_ = {});  // every node is held
  if (coarse_.cols() != 6 * aggregate_count()) allocate_coarse_matrix();
  ++assemblies_;
  assemble_coarse_matrix(matrix);
  factor_coarse_matrix();
}

void RigidModePreconditioner::build_coarse_pattern(const BlockSparseMatrix& matrix) {
  if (const std::vector<std::vector<int>> neighbors = coarse_neighbors(matrix); neighbors != coarse_rows_) {
    const std::vector<int> numbers = elimination_order(neighbors);
    renumber_aggregates(numbers);
    coarse_rows_ = renumbered(neighbors, numbers);
    coarse_.resize(0, 0);  // made by the next update: debris never needs one
  }
  coarse_slots_.assign(matrix.columns.size(), -1);
  for (int node = 0; node < node_rows(); ++node) {
    const std::vector<int>& rows = coarse_rows_[aggregates_[node]];
    for (int k = matrix.row_starts[node]; k < matrix.row_starts[node + 1] && matrix.columns[k] < node_rows(); ++k)
      if (const int other = aggregates_[matrix.columns[k]]; other >= aggregates_[node])
        coarse_slots_[k] = static_cast<int>(std::ranges::lower_bound(rows, other) - rows.begin());
  }
}

std::vector<std::vector<int>> RigidModePreconditioner::coarse_neighbors(const BlockSparseMatrix& matrix) const {
  std::vector<std::vector<int>> neighbors(aggregate_count());
  for (int a = 0; a < aggregate_count(); ++a) {
    std::vector<int>& found = neighbors[a];
    for (const int node : members_[a])
      for (int k = matrix.row_starts[node]; k < matrix.row_starts[node + 1] && matrix.columns[k] < node_rows(); ++k)
        if (const int other = aggregates_[matrix.columns[k]];
            other >= a && std::ranges::find(found, other) == found.end())
          found.push_back(other);
    std::ranges::sort(found);
  }
  return neighbors;
}

/// `numbers`: the new one of each.
void RigidModePreconditioner::renumber_aggregates(const std::vector<int>& numbers) {
  for (int& aggregate : aggregates_) aggregate = numbers[aggregate];
  std::vector<std::vector<int>> members(members_.size());
  for (std::size_t a = 0; a < members_.size(); ++a) members[numbers[a]] = std::move(members_[a]);
  members_ = std::move(members);
}

void RigidModePreconditioner::allocate_coarse_matrix() {
  std::vector<int> row_starts = {0}, rows;
  for (const std::vector<int>& neighbors : coarse_rows_)
    for (int mode = 0; mode < 6; ++mode) {
      for (int other : neighbors)
        for (int i = 0; i < 6; ++i) rows.push_back(6 * other + i);
      row_starts.push_back(static_cast<int>(rows.size()));
    }
  const std::vector<double> zeros(rows.size(), 0.0);
  const int modes = 6 * aggregate_count();
  coarse_ = Eigen::Map<const Eigen::SparseMatrix<double>>(modes, modes, static_cast<Eigen::Index>(rows.size()),
                                                          row_starts.data(), rows.data(), zeros.data());
  coarse_factors_.forget_pattern();
  factored_.resize(0);
}

void RigidModePreconditioner::assemble_coarse_matrix(const BlockSparseMatrix& matrix) {
  using CoarseBlock = Eigen::Map<Eigen::Matrix<double, 6, 6>, Eigen::Unaligned, Eigen::OuterStride<>>;
  std::fill(coarse_.valuePtr(), coarse_.valuePtr() + coarse_.nonZeros(), 0.0);
  parallel_for(aggregate_count(), 4, [&](int begin, int end) {
    std::vector<RigidModes> products;  // A R of a row, per neighboring aggregate
    for (int a = begin; a < end; ++a) {
      const int neighbors = static_cast<int>(coarse_rows_[a].size());
      double* const first = coarse_.valuePtr() + coarse_.outerIndexPtr()[6 * a];
      for (int node : members_[a]) {
        products.assign(neighbors, RigidModes::Zero());
        for (int k = matrix.row_starts[node]; k < matrix.row_starts[node + 1]; ++k)
          if (coarse_slots_[k] >= 0)
            products[coarse_slots_[k]].noalias() += matrix.blocks[k] * rigid_modes(known_.arms.col(matrix.columns[k]));
        const RigidModes modes_here = rigid_modes(known_.arms.col(node));
        for (int slot = 0; slot < neighbors; ++slot)
          CoarseBlock(first + 6 * slot, 6, 6, Eigen::OuterStride<>(6 * neighbors)) +=
              products[slot].transpose() * modes_here;
      }
    }
  });
  // Aggregates of one or two nodes have modes without motion: a small shift keeps the matrix definite.
  const double shift = 1e-12 * coarse_.diagonal().maxCoeff();
  for (int mode = 0; mode < coarse_.cols(); ++mode) {
    double& diagonal = coarse_.valuePtr()[coarse_.outerIndexPtr()[mode] + mode % 6];
    diagonal = diagonal * (1 + 1e-10) + shift;
  }
}

void RigidModePreconditioner::factor_coarse_matrix() {
  const auto values = coarse_.coeffs();
  if (factored_.size() == values.size() &&
      (values - factored_).matrix().squaredNorm() <= kSameMatrix * kSameMatrix * factored_.matrix().squaredNorm())
    return;
  ++factorizations_;
  const Eigen::SparseMatrix<double>* factors = coarse_factors_.factor(coarse_);
  if (!factors) {
    triangle_ = {};
    factored_.resize(0);
    return;
  }
  triangle_ = BlockTriangle(*factors);
  factored_ = values;
}

/// (Rᵀ A R)⁻¹ Rᵀ r: the six modes of each aggregate.
template <class Vectors>
std::vector<simd::Lanes> RigidModePreconditioner::solve_coarse(const Vectors& r) const {
  std::vector<simd::Lanes> modes(members_.size(), simd::Lanes{});
  if (!has_coarse_space()) return modes;
  for (int a = 0; a < aggregate_count(); ++a) {
    Vec3 force = Vec3::Zero(), torque = Vec3::Zero();
    for (int node : members_[a]) {
      const Vec3 at_node = vector_of(r, node);
      force += at_node;
      torque += known_.arms.col(node).cross(at_node);
    }
    for (int i = 0; i < 3; ++i) {
      modes[a][i] = static_cast<float>(force[i]);
      modes[a][3 + i] = static_cast<float>(torque[i]);
    }
  }
  triangle_.solve(modes);
  triangle_.solve_transposed(modes);
  return modes;
}

double RigidModePreconditioner::apply(const NodeVectors& r, NodeVectors& z) const {
  const std::vector<simd::Lanes> coarse = solve_coarse(r);
  z.resize(3, r.cols());
  return parallel_sum(static_cast<int>(r.cols()), [&](int begin, int end) {
    double sum = -0.0;
    for (int node = begin; node < end; ++node) {
      Vec3 change = known_.inverse_diagonal[node] * r.col(node);
      if (node < node_rows()) {
        const simd::Lanes modes = coarse[aggregates_[node]];
        const Vec3 shift(modes[0], modes[1], modes[2]), turn(modes[3], modes[4], modes[5]);
        change = change + shift + turn.cross(known_.arms.col(node));
      }
      for (int i = 0; i < 3; ++i) sum += r(i, node) * change[i];
      z.col(node) = change;
    }
    return sum;
  });
}

SinglePrecisionPreconditioner::SinglePrecisionPreconditioner(const RigidModePreconditioner& of)
    : of_(&of), nodes_(of.known_.inverse_diagonal.size()) {
  parallel_for(static_cast<int>(nodes_.size()), 4096, [&](int begin, int end) {
    for (int node = begin; node < end; ++node) {
      for (int i = 0; i < 3; ++i) nodes_[node].inverse_diagonal[i] = single(of.known_.inverse_diagonal[node].col(i));
      if (node < of.node_rows()) nodes_[node].arm = single(of.known_.arms.col(node));
    }
  });
}

double SinglePrecisionPreconditioner::apply(const SingleVectors& r, SingleVectors& z) const {
  const std::vector<simd::Lanes> coarse = of_->solve_coarse(r);
  return parallel_sum(static_cast<int>(r.size()), [&](int begin, int end) {
    double sum = -0.0;
    for (int node = begin; node < end; ++node) {
      const auto& [diagonal, arm] = nodes_[node];
      const simd::Quad here = r[node];
      z[node] = diagonal[0] * here[0] + diagonal[1] * here[1] + diagonal[2] * here[2];
      if (node < of_->node_rows()) {
        const simd::Lanes modes = coarse[of_->aggregates_[node]];
        const simd::Quad shift = {modes[0], modes[1], modes[2], 0}, turn = {modes[3], modes[4], modes[5], 0};
        z[node] = z[node] + shift + cross(turn, arm);
      }
      sum += vector_of(r, node).dot(vector_of(z, node));
    }
    return sum;
  });
}

}  // namespace griffith
