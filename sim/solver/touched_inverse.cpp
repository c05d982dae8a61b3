#include "sim/solver/touched_inverse.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "sim/core/sort_unique.h"
#include "sim/solver/dense_cholesky.h"
#include "sim/solver/factor_preconditioner.h"

namespace griffith {
namespace {

DenseColumns view(Eigen::MatrixXd& matrix) {
  const auto rows = static_cast<int>(matrix.rows());
  return {matrix.data(), rows, static_cast<int>(matrix.cols()), rows};
}

/// A Aᵀ.
Eigen::MatrixXd square(Eigen::MatrixXd a) {
  Eigen::MatrixXd product = Eigen::MatrixXd::Zero(a.rows(), a.rows());
  subtract_square(view(product), view(a));
  return (-product).selfadjointView<Eigen::Lower>();
}

/// (L⁻¹)ᵀ of the lower triangle of a matrix.
Eigen::MatrixXd transposed_inverse(const Eigen::MatrixXd& lower) {
  const Eigen::Index size = lower.rows();
  Eigen::MatrixXd inverse = Eigen::MatrixXd::Zero(size, size);
  Eigen::VectorXd unit(size);
  for (Eigen::Index j = 0; j < size; ++j) {
    unit.setZero();
    unit[j] = 1;
    for (Eigen::Index k = j; k < size; ++k) {
      unit[k] /= lower(k, k);
      for (Eigen::Index i = k + 1; i < size; ++i) unit[i] -= lower(i, k) * unit[k];
    }
    inverse.row(j) = unit.transpose();
  }
  return inverse;
}

/// The inverse of a compliance. A little more of it keeps apart what depends on each other: where all rows are touched,
/// six combinations of them do not deform the body.
Eigen::MatrixXd inverse_of(Eigen::MatrixXd compliance) {
  constexpr double kMore = 1e-7;
  if (compliance.rows() == 0) return compliance;
  compliance.diagonal().array() += kMore * compliance.diagonal().mean();
  if (!factor_panel(view(compliance))) return Eigen::MatrixXd::Zero(compliance.rows(), compliance.cols());
  return square(transposed_inverse(compliance));
}

/// Returns vectors, one a row, without the numbers that are zero in all of them. `fours`: four vectors each.
Eigen::MatrixXd filled_columns(const std::vector<std::vector<simd::WideQuad>>& fours, std::size_t vectors) {
  const std::size_t size = fours.empty() ? 0 : fours.front().size();
  std::vector<std::size_t> filled;
  for (std::size_t i = 0; i < size; ++i)
    if (std::ranges::any_of(fours, [&](const auto& four) { return simd::any_of(four[i] != 0.0); })) filled.push_back(i);
  Eigen::MatrixXd columns(static_cast<Eigen::Index>(vectors), static_cast<Eigen::Index>(filled.size()));
  for (std::size_t j = 0; j < filled.size(); ++j)
    for (std::size_t i = 0; i < vectors; ++i)
      columns(i, j) = fours[i / simd::kDoubleLanes][filled[j]][i % simd::kDoubleLanes];
  return columns;
}

/// Writes the product of a symmetric matrix and a vector.
void multiply_symmetric(const Eigen::MatrixXd& matrix, const double* x, double* product) {
  for (Eigen::Index j = 0; j < matrix.cols(); ++j)
    product[j] = dot_product(matrix.col(j).data(), x, static_cast<std::size_t>(matrix.rows()));
}

/// Returns the root of a semidefinite matrix. Bodies on a hinge have zero eigenvalues, which rounding makes negative.
Mat3 root_of(const Mat3& matrix) {
  const Eigen::SelfAdjointEigenSolver<Mat3> eigen(matrix);
  const Vec3 roots = eigen.eigenvalues().cwiseMax(0).cwiseSqrt();
  return eigen.eigenvectors() * roots.asDiagonal() * eigen.eigenvectors().transpose();
}

/// True if the dense matrix of touched rows takes more operations to factor than the sparse one of all rows.
bool condensing_costs_more(const FactorPreconditioner& factors, std::size_t touched) {
  const double unknowns = 3 * static_cast<double>(touched);
  return unknowns * unknowns * unknowns / 3 > static_cast<double>(factors.plan().operations());
}

}  // namespace

TouchedInverse::TouchedInverse(const DeformableInertia& body, std::vector<int> touched)
    : body_(body), touched_(std::move(touched)) {
  if (body.whole.exists()) {
    root_of_mass_ = std::sqrt(body.whole.inverse_mass / body.whole.damping);
    root_of_inertia_ = root_of(body.whole.inverse_inertia / body.whole.damping);
  }
  Eigen::MatrixXd units = filled_columns(reduce_units(), 3 * touched_.size());
  compliance_ = square(std::move(units));
  stiffness_ = inverse_of(compliance_);
}

RigidModes TouchedInverse::whole_turning(const Vec3& arm) const {
  RigidModes modes = rigid_modes(arm);
  modes.leftCols<3>().setZero();
  modes.rightCols<3>() = (modes.rightCols<3>() * root_of_inertia_).eval();
  return modes;
}

RigidModes TouchedInverse::whole_at(int row) const {
  RigidModes modes = whole_turning(body_.whole.arms.col(row));
  if (row < body_.whole.masses.size()) modes.leftCols<3>() = root_of_mass_ * Mat3::Identity();
  return modes;
}

std::vector<TouchedInverse::FourVectors> TouchedInverse::reduce_units() const {
  constexpr std::size_t kLanes = simd::kDoubleLanes;
  std::vector<FourVectors> reduced;
  std::array<NodeVectors, kLanes> units;
  for (std::size_t first = 0; first < 3 * touched_.size(); first += kLanes) {
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      units[lane].setZero(3, body_.rows());
      const std::size_t number = first + lane;
      if (number >= 3 * touched_.size()) continue;
      units[lane](static_cast<Eigen::Index>(number % 3), touched_[number / 3]) = 1;
      if (body_.whole.exists()) units[lane] -= body_.whole.momentum_of(units[lane]);
    }
    reduced.push_back(body_.factors->reduce(units));
  }
  return reduced;
}

Eigen::VectorXd TouchedInverse::multiply(const Eigen::Ref<const Eigen::VectorXd>& change) const {
  Eigen::VectorXd product = change;
  multiply_symmetric(stiffness_, change.data(), product.data());
  return product;
}

double TouchedInverse::squared_speed_under(const Eigen::Ref<const Eigen::VectorXd>& impulses) const {
  Eigen::VectorXd deforming(rows());
  multiply_symmetric(compliance_, impulses.data(), deforming.data());
  double largest = 0;
  for (std::size_t i = 0; i < touched_.size(); ++i) {
    largest = std::max(largest, deforming.segment<3>(static_cast<Eigen::Index>(3 * i)).squaredNorm());
    if (body_.whole.exists()) largest = std::max(largest, (whole_at(touched_[i]) * impulses.tail<6>()).squaredNorm());
  }
  return largest;
}

void TouchedInverse::add_side(const ContactSide& side, const Mat3& axes, int first, ContactJacobian& jacobian) const {
  const bool has_whole = body_.whole.exists();
  RigidModes of_whole = RigidModes::Zero();
  if (has_whole && !side.offset.isZero(0)) of_whole = axes * whole_turning(side.offset);
  for (int i = 0; i < 3; ++i) {
    const int row = side.point.rows[i];
    if (row < 0) continue;
    const Mat3 weight = axes * side.point.weights[i];
    jacobian.add(first + 3 * static_cast<int>(std::ranges::lower_bound(touched_, row) - touched_.begin()), weight);
    if (has_whole) of_whole += weight * whole_at(row);
  }
  if (has_whole) jacobian.add(first + rows(), of_whole);
}

std::vector<std::vector<int>> touched_rows(std::size_t bodies, std::span<const FrictionContact> contacts) {
  std::vector<std::vector<int>> touched(bodies);
  for (const FrictionContact& contact : contacts)
    for (const ContactSide* side : {&contact.a, &contact.b})
      if (side->body >= 0 && side->deformable)
        for (const int row : side->point.rows)
          if (row >= 0) touched[side->body].push_back(row);
  for (std::vector<int>& rows : touched) sort_unique(rows);
  return touched;
}

std::vector<std::optional<TouchedInverse>> condense(std::span<const DeformableInertia> bodies,
                                                    std::span<const FrictionContact> contacts) {
  std::vector<std::vector<int>> touched = touched_rows(bodies.size(), contacts);
  std::vector<std::optional<TouchedInverse>> condensed(bodies.size());
  for (std::size_t i = 0; i < bodies.size(); ++i)
    if (const FactorPreconditioner* factors = bodies[i].factors;
        factors && factors->exists() && !condensing_costs_more(*factors, touched[i].size()))
      condensed[i].emplace(bodies[i], std::move(touched[i]));
  return condensed;
}

}  // namespace griffith
