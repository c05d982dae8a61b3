#include "sim/solver/contact_preconditioner.h"

#include <Eigen/LU>
#include <algorithm>
#include <numeric>
#include <utility>

#include "sim/core/sort_unique.h"
#include "sim/solver/factor_preconditioner.h"
#include "sim/solver/rigid_motion.h"

namespace griffith {
namespace {

/// Columns of the 3×3 blocks of each row of a symmetric matrix.
using Pattern = std::vector<std::vector<int>>;

/// Adds all blocks that `rows` rows from `row` on share with `columns` columns from `column` on.
void add_blocks(int row, int rows, int column, int columns, Pattern& pattern) {
  for (int i = row; i < row + rows; ++i)
    for (int j = column; j < column + columns; ++j) {
      pattern[i].push_back(j);
      pattern[j].push_back(i);
    }
}

/// Returns zeros of a pattern.
BlockSparseMatrix zeros_of(Pattern pattern) {
  BlockSparseMatrix matrix;
  for (std::vector<int>& columns : pattern) {
    sort_unique(columns);
    matrix.columns.insert(matrix.columns.end(), columns.begin(), columns.end());
    matrix.row_starts.push_back(static_cast<int>(matrix.columns.size()));
  }
  matrix.blocks.assign(matrix.columns.size(), Mat3::Zero());
  return matrix;
}

/// Adds the lower triangle of a symmetric matrix of 3×3 blocks, and its mirror image, from a row on.
void add_symmetric(const Eigen::SparseMatrix<double>& lower, int first, BlockSparseMatrix& matrix) {
  for (int column = 0; column < lower.outerSize(); ++column)
    for (Eigen::SparseMatrix<double>::InnerIterator entry(lower, column); entry; ++entry) {
      const int row = static_cast<int>(entry.row());
      if (row < column) continue;
      matrix.blocks[matrix.slot(first + row / 3, first + column / 3)](row % 3, column % 3) += entry.value();
      if (row > column)
        matrix.blocks[matrix.slot(first + column / 3, first + row / 3)](column % 3, row % 3) += entry.value();
    }
}

/// Adds a matrix of 3×3 blocks from a row on.
void add_matrix(const BlockSparseMatrix& a, int first, BlockSparseMatrix& matrix) {
  for (int row = 0; row < a.rows(); ++row)
    for (int k = a.row_starts[row]; k < a.row_starts[row + 1]; ++k)
      matrix.blocks[matrix.slot(first + row, first + a.columns[k])] += a.blocks[k];
}

/// Adds a symmetric matrix from a row on.
void add_symmetric(const Eigen::MatrixXd& block, int first, BlockSparseMatrix& matrix) {
  for (int i = 0; 3 * i < block.rows(); ++i)
    for (int j = 0; 3 * j < block.cols(); ++j)
      matrix.blocks[matrix.slot(first + i, first + j)] += block.block<3, 3>(3 * i, 3 * j);
}

Mat3 inverse_diagonal(const DeformableInertia& body, int row) {
  if (body.matrix) return body.preconditioner->inverse_diagonal(row);
  return Mat3::Identity() / body.masses[row];
}

std::vector<int> all_rows(const DeformableInertia& body) {
  std::vector<int> rows(body.rows());
  std::iota(rows.begin(), rows.end(), 0);
  return rows;
}

int aggregate_count(const DeformableInertia& body) {
  return body.matrix && body.preconditioner->has_coarse_space() ? body.preconditioner->aggregate_count() : 0;
}

}  // namespace

int ContactPreconditioner::BodyUnknowns::row_unknown(int row) const {
  return first_touched + 3 * static_cast<int>(std::ranges::lower_bound(touched, row) - touched.begin());
}

ContactPreconditioner::ContactPreconditioner(const ContactBodies& bodies, std::span<const DeformableInertia> deformable,
                                             std::span<const RigidInertia> rigid,
                                             std::span<const FrictionContact> contacts)
    : deformable_(deformable), rigid_(rigid), bodies_(deformable.size()), rigid_offset_(bodies.first_of_rigid()) {
  std::vector<std::vector<int>> touched = touched_rows(deformable.size(), contacts);
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    bodies_[i].offset = bodies.first_of_deformable(i);
    bodies_[i].condensed = bodies.condensed(i);
    if (bodies_[i].condensed) continue;
    bodies_[i].has_all_rows =
        deformable[i].factors_with_contacts || (deformable[i].factors && deformable[i].factors->exists());
    bodies_[i].touched = bodies_[i].has_all_rows ? all_rows(deformable[i]) : std::move(touched[i]);
    reduce_coarse_space(i);
  }
  number_unknowns();
  build_jacobian(contacts);
  build_pattern();
  add_inertia();
  find_slots();
  plan_ = std::make_shared<const EliminationPlan>(plan_elimination(matrix_));
}

void ContactPreconditioner::reduce_coarse_space(std::size_t i) {
  if (bodies_[i].has_all_rows || aggregate_count(deformable_[i]) == 0) return;
  const RigidModePreconditioner& modes = *deformable_[i].preconditioner;
  std::vector<int> aggregates;
  for (const int row : bodies_[i].touched)
    if (row < modes.node_rows()) aggregates.push_back(modes.aggregate_of(row));
  sort_unique(aggregates);
  bodies_[i].reduction.emplace(modes.coarse_matrix(), aggregates);
}

void ContactPreconditioner::number_unknowns() {
  for (BodyUnknowns& body : bodies_) {
    body.first_touched = unknowns_;
    body.first_aggregate = unknowns_ + 3 * static_cast<int>(body.touched.size());
    unknowns_ = body.first_aggregate + (body.reduction ? 6 * body.reduction->kept() : 0);
    if (body.condensed) unknowns_ = body.first_touched + body.condensed->size();
  }
  first_rigid_ = unknowns_;
  unknowns_ += 6 * static_cast<int>(rigid_.size());
}

void ContactPreconditioner::add_side(const ContactSide& side, const Mat3& axes) {
  if (side.body < 0) return;
  if (!side.deformable) return jacobian_.add(first_rigid_ + 6 * side.body, axes * rigid_modes(side.arm));
  const BodyUnknowns& body = bodies_[side.body];
  if (body.condensed) return body.condensed->add_side(side, axes, body.first_touched, jacobian_);
  const DeformableInertia& inertia = deformable_[side.body];
  for (int i = 0; i < 3; ++i) {
    const int row = side.point.rows[i];
    if (row < 0) continue;
    const Mat3 weight = axes * side.point.weights[i];
    jacobian_.add(body.row_unknown(row), weight);
    if (!body.reduction || row >= inertia.preconditioner->node_rows()) continue;
    jacobian_.add(body.first_aggregate + 6 * body.reduction->slot(inertia.preconditioner->aggregate_of(row)),
                  weight * rigid_modes(inertia.preconditioner->arm(row)));
  }
}

void ContactPreconditioner::build_jacobian(std::span<const FrictionContact> contacts) {
  for (const FrictionContact& contact : contacts) {
    add_side(contact.a, contact.axes.transpose());
    add_side(contact.b, -contact.axes.transpose());
    jacobian_.finish_contact();
  }
}

void ContactPreconditioner::build_pattern() {
  Pattern pattern(unknowns_ / 3);
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    const BodyUnknowns& body = bodies_[i];
    const int first = body.first_touched / 3, first_aggregate = body.first_aggregate / 3;
    if (body.has_all_rows) {
      const BlockSparseMatrix& a = *deformable_[i].matrix;
      for (int row = 0; row < a.rows(); ++row)
        for (int k = a.row_starts[row]; k < a.row_starts[row + 1]; ++k)
          pattern[first + row].push_back(first + a.columns[k]);
    }
    if (body.condensed) {
      const int touched = body.condensed->rows() / 3, whole = body.condensed->size() / 3 - touched;
      add_blocks(first, touched, first, touched, pattern);
      add_blocks(first + touched, whole, first + touched, whole, pattern);
    }
    if (!body.reduction) continue;
    const Eigen::SparseMatrix<double>& coarse = body.reduction->matrix();
    for (int column = 0; column < coarse.outerSize(); ++column)
      for (Eigen::SparseMatrix<double>::InnerIterator entry(coarse, column); entry; ++entry)
        add_blocks(first_aggregate + static_cast<int>(entry.row()) / 3, 1, first_aggregate + column / 3, 1, pattern);
  }
  for (int row = first_rigid_ / 3; row < unknowns_ / 3; row += 2) add_blocks(row, 2, row, 2, pattern);
  for (int contact = 0; contact < jacobian_.contacts(); ++contact)
    for (const auto* p = jacobian_.begin(contact); p != jacobian_.end(contact); ++p)
      for (const auto* q = jacobian_.begin(contact); q <= p; ++q)
        add_blocks(p->offset / 3, p->width / 3, q->offset / 3, q->width / 3, pattern);
  matrix_ = zeros_of(std::move(pattern));
}

void ContactPreconditioner::add_inertia() {
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    const BodyUnknowns& body = bodies_[i];
    if (body.condensed) {
      const int touched = body.condensed->rows(), whole = body.condensed->size() - touched;
      add_symmetric(body.condensed->stiffness(), body.first_touched / 3, matrix_);
      add_symmetric(Eigen::MatrixXd::Identity(whole, whole), (body.first_touched + touched) / 3, matrix_);
      continue;
    }
    if (body.has_all_rows) {
      add_matrix(*deformable_[i].matrix, body.first_touched / 3, matrix_);
      continue;
    }
    for (const int row : body.touched)
      add_symmetric(Eigen::MatrixXd(inverse_diagonal(deformable_[i], row).inverse()), body.row_unknown(row) / 3,
                    matrix_);
    if (body.reduction) add_symmetric(body.reduction->matrix(), body.first_aggregate / 3, matrix_);
  }
  for (std::size_t i = 0; i < rigid_.size(); ++i) {
    const int first = first_rigid_ / 3 + 2 * static_cast<int>(i);
    add_symmetric(Eigen::MatrixXd(rigid_[i].mass * Mat3::Identity()), first, matrix_);
    add_symmetric(Eigen::MatrixXd(rigid_[i].inertia), first + 1, matrix_);
  }
  inertia_ = matrix_.blocks;
}

void ContactPreconditioner::find_slots() {
  for (int contact = 0; contact < jacobian_.contacts(); ++contact) {
    slot_starts_.push_back(slots_.size());
    for (const auto* p = jacobian_.begin(contact); p != jacobian_.end(contact); ++p)
      for (const auto* q = jacobian_.begin(contact); q <= p; ++q)
        for (int i = p->offset / 3; i < (p->offset + p->width) / 3; ++i)
          for (int j = q->offset / 3; j < (q->offset + q->width) / 3; ++j) {
            slots_.push_back(matrix_.slot(i, j));
            if (p != q) slots_.push_back(matrix_.slot(j, i));
          }
  }
}

bool ContactPreconditioner::factor(const std::vector<Mat3>& stiffness) {
  matrix_.blocks = inertia_;
  for (int contact = 0; contact < jacobian_.contacts(); ++contact) {
    if (stiffness[contact].isZero(0)) continue;  // open
    const int* slot = slots_.data() + slot_starts_[contact];
    for (const auto* p = jacobian_.begin(contact); p != jacobian_.end(contact); ++p) {
      const Eigen::Matrix<double, 6, 3> stiff = p->values.transpose() * stiffness[contact];
      for (const auto* q = jacobian_.begin(contact); q <= p; ++q)
        for (int i = 0; i < p->width; i += 3)
          for (int j = 0; j < q->width; j += 3) {
            const Mat3 product = stiff.middleRows<3>(i) * q->values.middleCols<3>(j);
            matrix_.blocks[*slot++] += product;
            if (p != q) matrix_.blocks[*slot++] += product.transpose();
          }
    }
  }
  if (!factors_) factors_.emplace(plan_);
  return factors_->factor_again(matrix_, space_);
}

Eigen::VectorXd ContactPreconditioner::solve(const Eigen::VectorXd& reduced) const {
  std::vector<double> x(reduced.size());
  const auto row = [&](std::size_t i) { return Eigen::Map<Vec3>(x.data() + std::size_t{3} * plan_->places[i]); };
  for (std::size_t i = 0; i < plan_->places.size(); ++i) row(i) = reduced.segment<3>(3 * i);
  factors_->solve(x);
  factors_->solve_transposed(x);
  Eigen::VectorXd solved(reduced.size());
  for (std::size_t i = 0; i < plan_->places.size(); ++i) solved.segment<3>(3 * i) = row(i);
  return solved;
}

namespace {

/// Rᵀ r of a body's coarse space.
Eigen::VectorXd coarse_residual(const RigidModePreconditioner& modes, const Eigen::Ref<const Eigen::VectorXd>& r) {
  Eigen::VectorXd coarse = Eigen::VectorXd::Zero(6 * modes.aggregate_count());
  for (int row = 0; row < modes.node_rows(); ++row) {
    const Vec3 at_row = r.segment<3>(3 * row);
    const int first = 6 * modes.aggregate_of(row);
    coarse.segment<3>(first) += at_row;
    coarse.segment<3>(first + 3) += modes.arm(row).cross(at_row);
  }
  return coarse;
}

/// Adds R c to z.
void add_coarse(const RigidModePreconditioner& modes, const Eigen::VectorXd& coarse, Eigen::Ref<Eigen::VectorXd> z) {
  for (int row = 0; row < modes.node_rows(); ++row) {
    const int first = 6 * modes.aggregate_of(row);
    z.segment<3>(3 * row) += coarse.segment<3>(first) + coarse.segment<3>(first + 3).cross(modes.arm(row));
  }
}

}  // namespace

void ContactPreconditioner::apply(const Eigen::VectorXd& r, Eigen::VectorXd& z) const {
  Eigen::VectorXd reduced = Eigen::VectorXd::Zero(unknowns_);
  std::vector<Eigen::VectorXd> coarse(bodies_.size());
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    const BodyUnknowns& body = bodies_[i];
    if (body.condensed) {
      reduced.segment(body.first_touched, body.condensed->size()) = r.segment(body.offset, body.condensed->size());
      continue;
    }
    for (const int row : body.touched) reduced.segment<3>(body.row_unknown(row)) = r.segment<3>(body.offset + 3 * row);
    if (!body.reduction) continue;
    coarse[i] = coarse_residual(*deformable_[i].preconditioner, r.segment(body.offset, 3 * deformable_[i].rows()));
    reduced.segment(body.first_aggregate, 6 * body.reduction->kept()) = body.reduction->restrict(coarse[i]);
  }
  reduced.tail(unknowns_ - first_rigid_) = r.tail(r.size() - rigid_offset_);
  const Eigen::VectorXd solved = solve(reduced);

  z.resize(r.size());
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    const BodyUnknowns& body = bodies_[i];
    if (body.condensed) {
      z.segment(body.offset, body.condensed->size()) = solved.segment(body.first_touched, body.condensed->size());
      continue;
    }
    auto of_body = z.segment(body.offset, 3 * deformable_[i].rows());
    for (int row = 0; row < deformable_[i].rows(); ++row)
      of_body.segment<3>(3 * row) = inverse_diagonal(deformable_[i], row) * r.segment<3>(body.offset + 3 * row);
    for (const int row : body.touched) of_body.segment<3>(3 * row) = solved.segment<3>(body.row_unknown(row));
    if (!body.reduction) continue;
    const auto kept = solved.segment(body.first_aggregate, 6 * body.reduction->kept());
    add_coarse(*deformable_[i].preconditioner, body.reduction->extend(kept, coarse[i]), of_body);
  }
  z.tail(r.size() - rigid_offset_) = solved.tail(unknowns_ - first_rigid_);
}

}  // namespace griffith
