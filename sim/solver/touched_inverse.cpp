#include "sim/solver/touched_inverse.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

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

}  // namespace

TouchedInverse::TouchedInverse(const DeformableInertia& body, std::span<const int> touched) : body_(body) {
  if (body.whole.exists()) {
    root_of_mass_ = std::sqrt(body.whole.inverse_mass / body.whole.damping);
    root_of_inertia_ =
        Eigen::SelfAdjointEigenSolver<Mat3>(body.whole.inverse_inertia / body.whole.damping).operatorSqrt();
  }
  const std::vector<std::vector<double>> columns = reduce_units(touched);
  const std::size_t size = columns.empty() ? 0 : columns.front().size();
  for (std::size_t i = 0; i < size; ++i)
    if (std::ranges::any_of(columns, [&](const std::vector<double>& column) { return column[i] != 0; }))
      filled_.push_back(static_cast<int>(i));
  units_.resize(static_cast<Eigen::Index>(columns.size()), static_cast<Eigen::Index>(filled_.size()));
  for (std::size_t j = 0; j < filled_.size(); ++j)
    for (std::size_t i = 0; i < columns.size(); ++i) units_(i, j) = columns[i][filled_[j]];
  stiffness_ = inverse_of(square(units_));
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

NodeVectors TouchedInverse::deforming(const NodeVectors& r) const {
  return body_.whole.exists() ? NodeVectors(r - body_.whole.momentum_of(r)) : r;
}

std::vector<std::vector<double>> TouchedInverse::reduce_units(std::span<const int> rows) const {
  constexpr std::size_t kLanes = simd::kDoubleLanes;
  std::vector<std::vector<double>> columns(3 * rows.size());
  for (std::size_t first = 0; first < columns.size(); first += kLanes) {
    const std::size_t used = std::min(kLanes, columns.size() - first);
    std::array<NodeVectors, kLanes> units;
    for (std::size_t lane = 0; lane < used; ++lane) {
      NodeVectors unit = NodeVectors::Zero(3, body_.rows());
      unit(static_cast<Eigen::Index>((first + lane) % 3), rows[(first + lane) / 3]) = 1;
      units[lane] = deforming(unit);
    }
    const std::vector<simd::WideQuad> reduced = body_.factors->reduce(units);
    for (std::size_t lane = 0; lane < used; ++lane)
      for (const simd::WideQuad& four : reduced) columns[first + lane].push_back(four[lane]);
  }
  return columns;
}

Eigen::VectorXd TouchedInverse::moved_by(const std::vector<double>& reduced) const {
  Eigen::VectorXd moved = Eigen::VectorXd::Zero(units_.rows());
  for (std::size_t j = 0; j < filled_.size(); ++j)
    for (Eigen::Index i = 0; i < moved.size(); ++i) moved[i] += units_(i, j) * reduced[filled_[j]];
  return moved;
}

Eigen::VectorXd TouchedInverse::restrict(const NodeVectors& r, std::vector<double>& reduced) const {
  reduced = body_.factors->reduce(deforming(r));
  Eigen::VectorXd of_unknowns = Eigen::VectorXd::Zero(size());
  of_unknowns.head(rows()) = stiffness_ * moved_by(reduced);
  if (body_.whole.exists())
    for (int row = 0; row < r.cols(); ++row) of_unknowns.tail<6>() += whole_at(row).transpose() * r.col(row);
  return of_unknowns;
}

void TouchedInverse::extend(const Eigen::VectorXd& solved, std::vector<double> reduced,
                            Eigen::Ref<NodeVectors> z) const {
  const Eigen::VectorXd force = stiffness_ * (solved.head(rows()) - moved_by(reduced));
  for (std::size_t j = 0; j < filled_.size(); ++j)
    reduced[filled_[j]] += dot_product(units_.data() + j * force.size(), force.data(), force.size());
  body_.factors->expand(std::move(reduced), z);
  if (!body_.whole.exists()) return;
  z -= body_.whole.part_of(z);
  for (int row = 0; row < z.cols(); ++row) z.col(row) += whole_at(row) * solved.tail<6>();
}

}  // namespace griffith
