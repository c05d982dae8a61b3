#include "sim/solver/preconditioner.h"

#include <Eigen/LU>
#include <algorithm>

#include "sim/parallel.h"
#include "sim/solver/aggregates.h"

namespace griffith {
namespace {

using ModeBlock = Eigen::Matrix<double, 3, 6>;

ModeBlock rigid_modes(const Vec3& arm) {
  ModeBlock modes;
  modes << 1, 0, 0, 0, arm.z(), -arm.y(),  //
      0, 1, 0, -arm.z(), 0, arm.x(),       //
      0, 0, 1, arm.y(), -arm.x(), 0;
  return modes;
}

}  // namespace

RigidModePreconditioner::RigidModePreconditioner(const BlockSparseMatrix& matrix, int aggregate_size)
    : aggregates_(aggregate_rows(matrix, aggregate_size)), inverse_diagonal_(matrix.rows()) {
  for (int node = 0; node < matrix.rows(); ++node) {
    if (aggregates_[node] >= aggregate_count()) members_.resize(aggregates_[node] + 1);
    members_[aggregates_[node]].push_back(node);
  }
}

void RigidModePreconditioner::update(const BlockSparseMatrix& matrix, const NodeVectors& positions) {
  parallel_for(matrix.rows(), 1024, [&](int begin, int end) {
    for (int node = begin; node < end; ++node) inverse_diagonal_[node] = matrix.blocks[matrix.slot(node, node)].inverse();
  });
  arms_.resize(3, matrix.rows());
  for (const std::vector<int>& nodes : members_) {
    Vec3 center = Vec3::Zero();
    for (int node : nodes) center += positions.col(node);
    center /= static_cast<double>(nodes.size());
    for (int node : nodes) arms_.col(node) = positions.col(node) - center;
  }
  assemble_coarse_matrix(matrix);
}

void RigidModePreconditioner::assemble_coarse_matrix(const BlockSparseMatrix& matrix) {
  const int modes = 6 * aggregate_count();
  Eigen::MatrixXd coarse = Eigen::MatrixXd::Zero(modes, modes);
  parallel_for(aggregate_count(), 4, [&](int begin, int end) {
    for (int a = begin; a < end; ++a)
      for (int node : members_[a]) {
        const ModeBlock modes_here = rigid_modes(arms_.col(node));
        for (int k = matrix.row_starts[node]; k < matrix.row_starts[node + 1]; ++k) {
          const int other = matrix.columns[k];
          // Only the lower triangle is read; one column block is written by one thread alone.
          if (aggregates_[other] < a) continue;
          coarse.block<6, 6>(6 * aggregates_[other], 6 * a) +=
              (matrix.blocks[k] * rigid_modes(arms_.col(other))).transpose() * modes_here;
        }
      }
  });
  // Aggregates of one or two nodes have modes that move nothing: a small shift keeps them harmless.
  coarse.diagonal() *= 1 + 1e-10;
  coarse.diagonal().array() += 1e-12 * coarse.diagonal().maxCoeff();
  coarse_.compute(coarse);
}

void RigidModePreconditioner::apply(const NodeVectors& r, NodeVectors& z) const {
  Eigen::VectorXd coarse(6 * aggregate_count());
  for (int a = 0; a < aggregate_count(); ++a) {
    Eigen::Matrix<double, 6, 1> sum = Eigen::Matrix<double, 6, 1>::Zero();
    for (int node : members_[a]) {
      sum.head<3>() += r.col(node);
      sum.tail<3>() += arms_.col(node).cross(r.col(node));
    }
    coarse.segment<6>(6 * a) = sum;
  }
  coarse_.solveInPlace(coarse);
  z.resize(3, r.cols());
  parallel_for(static_cast<int>(r.cols()), 2048, [&](int begin, int end) {
    for (int node = begin; node < end; ++node) {
      const int a = aggregates_[node];
      z.col(node) = inverse_diagonal_[node] * r.col(node) + coarse.segment<3>(6 * a) +
                    coarse.segment<3>(6 * a + 3).cross(arms_.col(node));
    }
  });
}

}  // namespace griffith
