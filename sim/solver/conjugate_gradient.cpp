#include "sim/solver/conjugate_gradient.h"

#include <cmath>

#include "sim/core/parallel.h"

namespace griffith {
namespace {

/// p becomes z + factor · p.
void turn_direction(const NodeVectors& z, double factor, NodeVectors& p) {
  parallel_for(static_cast<int>(p.cols()), 2048, [&](int begin, int end) {
    p.middleCols(begin, end - begin) = z.middleCols(begin, end - begin) + factor * p.middleCols(begin, end - begin);
  });
}

/// Goes a step along p. Returns the square of the new residual as dot() does, in one pass: its sum, one term after the
/// other, hides behind the rest.
double go_along(double step, const NodeVectors& p, const NodeVectors& a_p, NodeVectors& x, NodeVectors& r) {
  return parallel_sum(static_cast<int>(x.cols()), [&](int begin, int end) {
    double sum = -0.0;
    for (Eigen::Index i = 3 * begin; i < 3 * end; ++i) {
      x.data()[i] += step * p.data()[i];
      const double residual = r.data()[i] - step * a_p.data()[i];
      r.data()[i] = residual;
      sum += residual * residual;
    }
    return sum;
  });
}

}  // namespace

SolveReport conjugate_gradient(const BlockSparseMatrix& a, const RigidModePreconditioner& preconditioner,
                               const NodeVectors& b, NodeVectors& x, double tolerance, double scale, int max_iterations,
                               const std::function<bool()>& given_up) {
  NodeVectors a_p, z;
  multiply(a, x, a_p);
  const double guess_energy = dot(x, a_p);
  const double guess_scale = guess_energy > 0 ? dot(x, b) / guess_energy : 0;
  x *= guess_scale;
  NodeVectors r = b - guess_scale * a_p;
  double residual = std::sqrt(dot(r, r));
  const double target = tolerance * scale;

  SolveReport report;
  NodeVectors p;
  double rho = 0;
  while (residual > target && report.iterations < max_iterations && !(given_up && given_up())) {
    const double previous_rho = rho;
    rho = preconditioner.apply(r, z);
    report.iterations == 0 ? void(p = z) : turn_direction(z, rho / previous_rho, p);
    multiply(a, p, a_p);
    const double step = rho / dot(p, a_p);
    if (!std::isfinite(step)) break;
    residual = std::sqrt(go_along(step, p, a_p, x, r));
    ++report.iterations;
  }
  report.relative_residual = scale > 0 ? residual / scale : 0;
  report.converged = residual <= target;
  return report;
}

}  // namespace griffith
