#include "sim/solver/conjugate_gradient.h"

#include <cmath>

#include "sim/core/parallel.h"
#include "sim/solver/single_precision.h"

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

/// Whether a matrix moves through memory in each product, and the tolerance is one that single precision mostly
/// reaches.
bool suits_single_precision(const BlockSparseMatrix& a, double tolerance) {
  constexpr int kBeyondCache = 4096;  // rows
  return a.rows() >= kBeyondCache && tolerance >= 1e-5;
}

/// Refines x in single precision (Wilkinson 1963), residuals in double, until |r| <= target or that brings no more.
/// Returns the iterations made.
int refine_in_single_precision(const BlockSparseMatrix& a, const RigidModePreconditioner& preconditioner,
                               const NodeVectors& b, double target, int max_iterations,
                               const std::function<bool()>& given_up, NodeVectors& x, NodeVectors& r) {
  constexpr double kWorthwhile = 0.25;  // of the residual before
  int iterations = 0;
  for (double left = std::sqrt(dot(r, r)), before = INFINITY; left > target && left < kWorthwhile * before;) {
    before = left;
    NodeVectors refined, a_x;
    iterations +=
        solve_in_single_precision(a, preconditioner, r, 0.9 * target, max_iterations - iterations, given_up, refined);
    refined += x;
    multiply(a, refined, a_x);
    a_x = b - a_x;
    left = std::sqrt(dot(a_x, a_x));
    if (!(left < before)) break;
    x = std::move(refined);
    r = std::move(a_x);
  }
  return iterations;
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
  if (suits_single_precision(a, tolerance)) {
    report.iterations = refine_in_single_precision(a, preconditioner, b, target, max_iterations, given_up, x, r);
    residual = std::sqrt(dot(r, r));
  }
  NodeVectors p;
  double rho = 0;
  while (residual > target && report.iterations < max_iterations && !(given_up && given_up())) {
    const double previous_rho = rho;
    rho = preconditioner.apply(r, z);
    p.size() == 0 ? void(p = z) : turn_direction(z, rho / previous_rho, p);
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
