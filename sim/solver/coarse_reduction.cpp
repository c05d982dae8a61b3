#include "sim/solver/coarse_reduction.h"

#include <numeric>

namespace griffith {
namespace {

std::vector<int> slots_of(const std::vector<int>& aggregates, std::size_t count) {
  std::vector<int> slots(count, -1);
  for (std::size_t i = 0; i < aggregates.size(); ++i) slots[aggregates[i]] = static_cast<int>(i);
  return slots;
}

/// Index of a mode by the slots of aggregates, -1 if its aggregate has none.
int mode_in(const std::vector<int>& slots, Eigen::Index mode) {
  const int slot = slots[mode / 6];
  return slot < 0 ? -1 : 6 * slot + static_cast<int>(mode % 6);
}

}  // namespace

CoarseReduction::CoarseReduction(const Eigen::SparseMatrix<double>& coarse, const std::vector<int>& touched) {
  constexpr std::size_t kWorthwhile = 3;  // times as many aggregates as are touched: what is left is dense
  const auto count = static_cast<std::size_t>(coarse.cols() / 6);
  const bool reduces = kWorthwhile * touched.size() <= count;
  if (reduces) {
    kept_ = touched;
  } else {
    kept_.resize(count);
    std::iota(kept_.begin(), kept_.end(), 0);
  }
  slots_ = slots_of(kept_, count);
  for (std::size_t i = 0; i < count; ++i)
    if (slots_[i] < 0) eliminated_.push_back(static_cast<int>(i));
  other_slots_ = slots_of(eliminated_, count);
  if (reduces) {
    eliminate(coarse);
  } else {
    matrix_ = coarse.triangularView<Eigen::Lower>();
  }
}

void CoarseReduction::eliminate(const Eigen::SparseMatrix<double>& coarse) {
  const auto kept = static_cast<Eigen::Index>(6 * kept_.size()),
             others = static_cast<Eigen::Index>(coarse.cols() - kept);
  Eigen::MatrixXd own = Eigen::MatrixXd::Zero(kept, kept), coupling = Eigen::MatrixXd::Zero(others, kept);
  std::vector<Eigen::Triplet<double>> triplets;
  for (Eigen::Index column = 0; column < coarse.outerSize(); ++column)
    for (Eigen::SparseMatrix<double>::InnerIterator entry(coarse, column); entry; ++entry) {
      if (entry.row() < column) continue;
      const int row_kept = mode_in(slots_, entry.row()), column_kept = mode_in(slots_, column);
      const int row_other = mode_in(other_slots_, entry.row()), column_other = mode_in(other_slots_, column);
      if (row_kept >= 0 && column_kept >= 0) own(row_kept, column_kept) = entry.value();
      if (row_other >= 0 && column_other >= 0) triplets.emplace_back(row_other, column_other, entry.value());
      if (row_other >= 0 && column_kept >= 0) coupling(row_other, column_kept) = entry.value();
      if (row_kept >= 0 && column_other >= 0) coupling(column_other, row_kept) = entry.value();
    }
  Eigen::SparseMatrix<double> matrix(others, others);
  matrix.setFromTriplets(triplets.begin(), triplets.end());
  factors_.compute(matrix);
  carried_ = factors_.solve(coupling);
  own.triangularView<Eigen::Lower>() -= coupling.transpose() * carried_;
  matrix_ = own.triangularView<Eigen::Lower>().toDenseMatrix().sparseView(0, 0);
}

Eigen::VectorXd CoarseReduction::gather(const Eigen::VectorXd& all, const std::vector<int>& aggregates) const {
  Eigen::VectorXd of_these(6 * aggregates.size());
  for (std::size_t i = 0; i < aggregates.size(); ++i)
    of_these.segment<6>(6 * static_cast<Eigen::Index>(i)) = all.segment<6>(6 * aggregates[i]);
  return of_these;
}

Eigen::VectorXd CoarseReduction::restrict(const Eigen::VectorXd& residual) const {
  if (eliminated_.empty()) return residual;
  return gather(residual, kept_) - carried_.transpose() * gather(residual, eliminated_);
}

Eigen::VectorXd CoarseReduction::extend(const Eigen::VectorXd& kept, const Eigen::VectorXd& residual) const {
  if (eliminated_.empty()) return kept;
  const Eigen::VectorXd others = factors_.solve(gather(residual, eliminated_)) - carried_ * kept;
  Eigen::VectorXd all(residual.size());
  for (std::size_t i = 0; i < kept_.size(); ++i)
    all.segment<6>(6 * kept_[i]) = kept.segment<6>(6 * static_cast<Eigen::Index>(i));
  for (std::size_t i = 0; i < eliminated_.size(); ++i)
    all.segment<6>(6 * eliminated_[i]) = others.segment<6>(6 * static_cast<Eigen::Index>(i));
  return all;
}

}  // namespace griffith
