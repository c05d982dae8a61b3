#include "sim/solver/factor_preconditioner.h"

#include <algorithm>
#include <utility>

#include "sim/elasticity/polar_decomposition.h"

namespace griffith {
namespace {

/// About what a factorization costs, in iterations of conjugate gradients.
double cost_in_iterations(const EliminationPlan& plan) {
  constexpr double kFaster = 4;  // by operation: factors are computed in cache, solves wait for memory
  const double solve = 2 * static_cast<double>(plan.entries());
  return std::max(4.0, static_cast<double>(plan.operations()) / (kFaster * solve));
}

}  // namespace

bool FactorPreconditioner::is_affordable(const EliminationPlan& plan) {
  constexpr std::int64_t kMost = 100'000'000;  // numbers
  return plan.entries() <= kMost;
}

FactorPreconditioner::FactorPreconditioner(EliminationPlan plan, std::vector<TetId> tets)
    : plan_(std::make_shared<const EliminationPlan>(std::move(plan))),
      tets_(std::make_shared<const std::vector<TetId>>(std::move(tets))) {}

void FactorPreconditioner::update(const BlockSparseMatrix& matrix, const MatrixFactors& made_of,
                                  std::span<const ElementState> states) {
  if (exists()) {
    Mat3 turned = Mat3::Zero();
    for (std::size_t i = 0; i < tets_->size(); ++i) turned += states[(*tets_)[i]].frame * state_->frames[i].transpose();
    rotation_ = polar_rotation(turned);
  }
  if (!exists() || wasted_iterations_ > cost_in_iterations(*plan_) || !still_hold(made_of, states))
    factor(matrix, made_of, states);
}

/// True if the matrix is about the same, turned. Its scale does not matter.
bool FactorPreconditioner::still_hold(const MatrixFactors& made_of, std::span<const ElementState> states) const {
  constexpr double kStep = 1.1, kTurn = 0.02;
  const double now = made_of.stiffness * state_->made_of.mass, then = state_->made_of.stiffness * made_of.mass;
  if (now > kStep * then || then > kStep * now) return false;
  double squares = 0;
  for (std::size_t i = 0; i < tets_->size(); ++i)
    squares += (states[(*tets_)[i]].frame - rotation_ * state_->frames[i]).squaredNorm();
  return squares <= kTurn * kTurn * static_cast<double>(tets_->size());
}

void FactorPreconditioner::factor(const BlockSparseMatrix& matrix, const MatrixFactors& made_of,
                                  std::span<const ElementState> states) {
  ++factorizations_;
  fresh_iterations_ = -1;
  wasted_iterations_ = 0;
  rotation_ = Mat3::Identity();
  state_ = nullptr;
  Factored made{BlockCholesky::factor(plan_, matrix), made_of, {}};
  if (!made.factors) return;
  for (const TetId tet : *tets_) made.frames.push_back(states[tet].frame);
  state_ = std::make_shared<const Factored>(std::move(made));
}

void FactorPreconditioner::count_iterations(int iterations) {
  if (fresh_iterations_ < 0) fresh_iterations_ = iterations;
  wasted_iterations_ += std::max(0, iterations - fresh_iterations_);
}

std::vector<double> FactorPreconditioner::reduce(const NodeVectors& r) const {
  std::vector<double> reduced(r.size());
  for (Eigen::Index row = 0; row < r.cols(); ++row)
    Eigen::Map<Vec3>(reduced.data() + std::size_t{3} * plan_->places[row]) = rotation_.transpose() * r.col(row);
  state_->factors->solve(reduced);
  return reduced;
}

void FactorPreconditioner::expand(std::vector<double> reduced, Eigen::Ref<NodeVectors> z) const {
  state_->factors->solve_transposed(reduced);
  for (Eigen::Index row = 0; row < z.cols(); ++row)
    z.col(row) = rotation_ * Eigen::Map<const Vec3>(reduced.data() + std::size_t{3} * plan_->places[row]);
}

double FactorPreconditioner::apply(const NodeVectors& r, NodeVectors& z) const {
  z.resize(3, r.cols());
  expand(reduce(r), z);
  return dot(r, z);
}

std::vector<simd::WideQuad> FactorPreconditioner::reduce(const std::array<NodeVectors, simd::kDoubleLanes>& r) const {
  std::vector<simd::WideQuad> reduced(3 * plan_->places.size());
  for (std::size_t lane = 0; lane < r.size(); ++lane)
    for (Eigen::Index row = 0; row < r[lane].cols(); ++row) {
      const Vec3 turned = rotation_.transpose() * r[lane].col(row);
      for (int k = 0; k < 3; ++k) reduced[std::size_t{3} * plan_->places[row] + k][lane] = turned[k];
    }
  state_->factors->solve(reduced);
  return reduced;
}

std::size_t FactorPreconditioner::memory() const {
  return exists() ? state_->factors->memory() + state_->frames.size() * sizeof(Mat3) : 0;
}

}  // namespace griffith
