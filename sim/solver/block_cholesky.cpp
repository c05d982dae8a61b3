#include "sim/solver/block_cholesky.h"

#include <algorithm>
#include <utility>

#include "sim/solver/dense_cholesky.h"

namespace griffith {
namespace {

/// Schur complement of a front for the rows below it: the lower triangle of a symmetric matrix, by columns.
using Remainder = std::vector<double>;

/// One front's columns and remainder, while it is assembled.
class FrontAssembly {
 public:
  FrontAssembly(const EliminationPlan& plan, const BlockSparseMatrix& a)
      : plan_(plan), a_(a), row_at_(plan.places.size()), local_(plan.places.size(), -1) {
    for (std::size_t row = 0; row < plan.places.size(); ++row) row_at_[plan.places[row]] = static_cast<int>(row);
  }

  /// `columns`: zeros, to be filled; `remainder` is made.
  void begin(const Front& front, double* columns, Remainder& remainder) {
    front_ = &front;
    columns_ = columns;
    remainder_ = &remainder;
    const std::size_t below = 3 * front.below.size();
    remainder.assign(below * below, 0.0);
    for (int i = 0; i < front.columns; ++i) local_[front.first + i] = i;
    for (std::size_t i = 0; i < front.below.size(); ++i) local_[front.below[i]] = front.columns + static_cast<int>(i);
  }
  void add_matrix() {
    for (int place = front_->first; place < front_->first + front_->columns; ++place) {
      const int row = row_at_[place];
      for (int k = a_.row_starts[row]; k < a_.row_starts[row + 1]; ++k)
        if (const int other = plan_.places[a_.columns[k]]; other >= place)
          add_block(local_[other], local_[place], a_.blocks[k].data(), 3, true);
    }
  }
  void add_child(const Front& child, const Remainder& of_child) {
    const int count = static_cast<int>(child.below.size());
    for (int j = 0; j < count; ++j)
      for (int i = j; i < count; ++i)
        add_block(local_[child.below[i]], local_[child.below[j]],
                  of_child.data() + 3 * i + static_cast<std::size_t>(9 * count) * j, 3 * count, false);
  }

 private:
  /// Adds a block by columns, or a transposed one.
  void add_block(int row, int column, const double* block, int stride, bool transposed) {
    const bool below = column >= front_->columns;
    const int first = below ? front_->columns : 0, rows = 3 * (front_->rows() - first);
    double* to = (below ? remainder_->data() : columns_) + 3 * (row - first) +
                 static_cast<std::size_t>(3 * (column - first)) * rows;
    for (int j = 0; j < 3; ++j, to += rows)
      for (int i = 0; i < 3; ++i) to[i] += transposed ? block[j + stride * i] : block[i + stride * j];
  }

  const EliminationPlan& plan_;
  const BlockSparseMatrix& a_;
  std::vector<int> row_at_;  // per place
  std::vector<int> local_;   // per place: index among the rows of the front
  const Front* front_ = nullptr;
  double* columns_ = nullptr;
  Remainder* remainder_ = nullptr;
};

template <class Number>
bool is_zero(std::span<const Number> x) {
  for (const Number& number : x) {
    if constexpr (std::is_same_v<Number, double>) {
      if (number != 0) return false;
    } else {
      if (simd::any_of(number != 0.0)) return false;
    }
  }
  return true;
}

/// y −= Σ columns · x, four columns at a time.
template <class Number>
void subtract_columns(const double* columns, int stride, std::span<const Number> x, std::span<Number> y) {
  std::size_t j = 0;
  const auto column = [&](std::size_t k) { return columns + k * stride; };
  for (; j + 4 <= x.size(); j += 4) {
    const double *const a = column(j), *const b = column(j + 1), *const c = column(j + 2), *const d = column(j + 3);
    const Number x0 = x[j], x1 = x[j + 1], x2 = x[j + 2], x3 = x[j + 3];
    for (std::size_t i = 0; i < y.size(); ++i) y[i] = (((y[i] - a[i] * x0) - b[i] * x1) - c[i] * x2) - d[i] * x3;
  }
  for (; j < x.size(); ++j)
    for (std::size_t i = 0; i < y.size(); ++i) y[i] -= column(j)[i] * x[j];
}

}  // namespace

BlockCholesky::BlockCholesky(std::shared_ptr<const EliminationPlan> plan) : plan_(std::move(plan)) {
  std::size_t size = 0;
  for (const Front& front : plan_->fronts) {
    starts_.push_back(size);
    size += std::size_t{9} * front.columns * front.rows();
  }
  starts_.push_back(size);
}

std::shared_ptr<const BlockCholesky> BlockCholesky::factor(std::shared_ptr<const EliminationPlan> plan,
                                                           const BlockSparseMatrix& a) {
  const auto made = std::make_shared<BlockCholesky>(std::move(plan));
  Workspace space;
  if (!made->factor_again(a, space)) return nullptr;
  return made;
}

bool BlockCholesky::factor_again(const BlockSparseMatrix& a, Workspace& space) {
  const std::vector<Front>& fronts = plan_->fronts;
  values_.assign(starts_.back(), 0.0);
  std::vector<std::vector<int>> children(fronts.size());
  for (std::size_t i = 0; i < fronts.size(); ++i)
    if (fronts[i].parent >= 0) children[fronts[i].parent].push_back(static_cast<int>(i));
  std::vector<Remainder> remainders(fronts.size());
  FrontAssembly assembly(*plan_, a);
  for (std::size_t i = 0; i < fronts.size(); ++i) {
    const Front& front = fronts[i];
    if (!space.free.empty()) {
      remainders[i] = std::move(space.free.back());
      space.free.pop_back();
    }
    assembly.begin(front, columns_of(i), remainders[i]);
    assembly.add_matrix();
    for (const int child : children[i]) {
      assembly.add_child(fronts[child], remainders[child]);
      space.free.push_back(std::move(remainders[child]));
    }
    const int rows = 3 * front.rows(), columns = 3 * front.columns;
    const DenseColumns panel{columns_of(i), rows, columns, rows};
    if (!factor_panel(panel)) return false;
    subtract_square({remainders[i].data(), rows - columns, rows - columns, rows - columns},
                    {columns_of(i) + columns, rows - columns, columns, rows});
  }
  return true;
}

template <class Number>
void BlockCholesky::solve_forward(std::span<Number> x) const {
  std::vector<Number> filled;
  for (std::size_t f = 0; f < plan_->fronts.size(); ++f) {
    const Front& front = plan_->fronts[f];
    const int rows = 3 * front.rows(), columns = 3 * front.columns;
    const std::span<Number> own = x.subspan(3 * static_cast<std::size_t>(front.first), columns);
    if (is_zero(std::span<const Number>(own))) continue;  // as most are where little is given
    const double* const values = columns_of(f);
    for (int j = 0; j < columns; ++j) {
      const double* const column = values + static_cast<std::size_t>(j) * rows;
      own[j] /= column[j];
      for (int i = j + 1; i < columns; ++i) own[i] -= column[i] * own[j];
    }
    filled.assign(rows - columns, Number{});
    subtract_columns<Number>(values + columns, rows, own, filled);
    for (std::size_t i = 0; i < front.below.size(); ++i)
      for (std::size_t k = 0; k < 3; ++k) x[3 * static_cast<std::size_t>(front.below[i]) + k] += filled[3 * i + k];
  }
}

template void BlockCholesky::solve_forward<double>(std::span<double> x) const;
template void BlockCholesky::solve_forward<simd::WideQuad>(std::span<simd::WideQuad> x) const;

void BlockCholesky::solve_transposed(std::span<double> x) const {
  std::vector<double> known;  // the front's own numbers, then those below
  for (std::size_t f = plan_->fronts.size(); f-- > 0;) {
    const Front& front = plan_->fronts[f];
    const int rows = 3 * front.rows(), columns = 3 * front.columns;
    const std::span<double> own = x.subspan(3 * static_cast<std::size_t>(front.first), columns);
    known.assign(own.begin(), own.end());
    for (const int place : front.below)
      for (int k = 0; k < 3; ++k) known.push_back(x[3 * static_cast<std::size_t>(place) + k]);
    for (int j = columns; j-- > 0;) {
      const double* const column = columns_of(f) + static_cast<std::size_t>(j) * rows;
      known[j] = (known[j] - dot_product(column + j + 1, known.data() + j + 1, rows - j - 1)) / column[j];
    }
    std::copy_n(known.begin(), columns, own.begin());
  }
}

}  // namespace griffith
