#include "sim/solver/single_precision.h"

#include <cmath>
#include <cstring>

#include "sim/core/parallel.h"
#include "sim/solver/conjugate_gradient_loop.h"

namespace griffith {
namespace {

simd::Quad load(const float* numbers) {
  simd::Quad loaded;
  std::memcpy(&loaded, numbers, sizeof loaded);
  return loaded;
}

/// Returns the dot product of the first three lanes.
double dot(simd::Quad a, simd::Quad b) {
  return static_cast<double>(a[0]) * static_cast<double>(b[0]) + static_cast<double>(a[1]) * static_cast<double>(b[1]) +
         static_cast<double>(a[2]) * static_cast<double>(b[2]);
}

SingleVectors single(const NodeVectors& vectors, double factor) {
  SingleVectors converted(vectors.cols());
  parallel_for(static_cast<int>(vectors.cols()), 4096, [&](int begin, int end) {
    for (int i = begin; i < end; ++i) {
      const Eigen::Vector3f values = (factor * vectors.col(i)).cast<float>();
      converted[i] = simd::Quad{values[0], values[1], values[2], 0};
    }
  });
  return converted;
}

/// Returns the blocks of a matrix one after the other, by columns, with room to read four numbers anywhere.
std::vector<float> single(const std::vector<Mat3>& blocks) {
  std::vector<float> numbers(9 * blocks.size() + 1);
  parallel_for(static_cast<int>(blocks.size()), 16384, [&](int begin, int end) {
    for (std::size_t i = 9 * static_cast<std::size_t>(begin); i < 9 * static_cast<std::size_t>(end); ++i)
      numbers[i] = static_cast<float>(blocks[i / 9].data()[i % 9]);
  });
  return numbers;
}

/// Returns the product of a block and the first three lanes of `x`; the fourth lane of the result is meaningless.
simd::Quad times(const float* block, simd::Quad x) {
  return load(block) * x[0] + load(block + 3) * x[1] + load(block + 6) * x[2];
}

/// Vectors of the iterations in single precision: see iterate_conjugate_gradients().
struct SinglePrecisionSystem {
  const BlockSparseMatrix& a;
  const std::vector<float> blocks;
  const SinglePrecisionPreconditioner preconditioner;
  SingleVectors r;
  SingleVectors x = SingleVectors(r.size()), p = x, a_p = x, z = x;

  double precondition() { return preconditioner.apply(r, z); }
  void begin() { p = z; }
  void update_direction(double factor) {
    parallel_for(static_cast<int>(p.size()), 4096, [&](int begin, int end) {
      for (int i = begin; i < end; ++i) p[i] = z[i] + static_cast<float>(factor) * p[i];
    });
  }
  double multiply() {
    return parallel_sum(a.rows(), [&](int begin, int end) {
      double sum = -0.0;
      for (int row = begin; row < end; ++row) {
        simd::Quad of_row = {};
        for (int k = a.row_starts[row]; k < a.row_starts[row + 1]; ++k)
          of_row += times(blocks.data() + 9 * static_cast<std::size_t>(k), p[a.columns[k]]);
        of_row[3] = 0;
        a_p[row] = of_row;
        sum += dot(p[row], of_row);
      }
      return sum;
    });
  }
  double advance_solution(double step) {
    return parallel_sum(static_cast<int>(x.size()), [&](int begin, int end) {
      double sum = -0.0;
      for (int i = begin; i < end; ++i) {
        x[i] += static_cast<float>(step) * p[i];
        r[i] -= static_cast<float>(step) * a_p[i];
        sum += dot(r[i], r[i]);
      }
      return sum;
    });
  }
};

}  // namespace

int solve_in_single_precision(const BlockSparseMatrix& a, const RigidModePreconditioner& preconditioner,
                              const NodeVectors& r, double target, int max_iterations,
                              const std::function<bool()>& cancelled, NodeVectors& d) {
  const double size = std::sqrt(griffith::dot(r, r));  // numbers near one neither overflow nor vanish
  SinglePrecisionSystem system{a, single(a.blocks), SinglePrecisionPreconditioner(preconditioner), single(r, 1 / size)};
  int iterations = 0;
  iterate_conjugate_gradients(system, 1, target / size, max_iterations, cancelled, iterations);
  d.resize(3, r.cols());
  for (Eigen::Index i = 0; i < d.cols(); ++i)
    for (int axis = 0; axis < 3; ++axis) d(axis, i) = size * static_cast<double>(system.x[i][axis]);
  return iterations;
}

}  // namespace griffith
