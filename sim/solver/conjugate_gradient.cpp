#include "sim/solver/conjugate_gradient.h"

#include <cmath>

#include "sim/core/parallel.h"
#include "sim/solver/conjugate_gradient_loop.h"
#include "sim/solver/single_precision.h"

namespace griffith {
namespace {

/// Vectors of the iterations in double precision: see iterate_conjugate_gradients().
struct DoubleVectors {
  const BlockSparseMatrix& a;
  const Preconditioning& preconditioner;
  const WholeMotion* beside;
  NodeVectors &x, &r;
  NodeVectors p = {}, a_p = {}, z = {};

  double precondition() {
    const double product = preconditioner.apply(r, z);
    if (!beside) return product;
    z -= beside->part_of(z);
    return dot(r, z);
  }
  void begin() { p = z; }
  void update_direction(double factor) {
    parallel_for(static_cast<int>(p.cols()), 2048, [&](int begin, int end) {
      p.middleCols(begin, end - begin) = z.middleCols(begin, end - begin) + factor * p.middleCols(begin, end - begin);
    });
  }
  double multiply() {
    griffith::multiply(a, p, a_p);
    if (beside) a_p -= beside->momentum_of(a_p);
    return dot(p, a_p);
  }
  /// Sums like dot(), in one pass with the update.
  double advance_solution(double step) {
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
};

/// True if a matrix exceeds the cache, so that each product reads it from memory, and the tolerance is one that single
/// precision usually reaches.
bool suits_single_precision(const BlockSparseMatrix& a, double tolerance) {
  constexpr int kBeyondCache = 4096;  // rows
  return a.rows() >= kBeyondCache && tolerance >= 1e-5;
}

/// Refines x in single precision (Wilkinson 1963), residuals in double, until their norm `left` is at most `target` or
/// that brings no more. Returns the iterations made. `beside`: as in conjugate_gradient().
int refine_in_single_precision(const BlockSparseMatrix& a, const RigidModePreconditioner& preconditioner,
                               const NodeVectors& b, double target, int max_iterations,
                               const std::function<bool()>& cancelled, const WholeMotion* beside, NodeVectors& x,
                               NodeVectors& r, double& left) {
  constexpr double kWorthwhile = 0.25;  // of the residual before
  int iterations = 0;
  for (double before = INFINITY; left > target && left < kWorthwhile * before;) {
    NodeVectors refined, a_x;
    iterations +=
        solve_in_single_precision(a, preconditioner, r, 0.9 * target, max_iterations - iterations, cancelled, refined);
    if (beside) refined -= beside->part_of(refined);
    refined += x;
    multiply(a, refined, a_x);
    a_x = b - a_x;
    if (beside) a_x -= beside->momentum_of(a_x);
    before = left;
    const double after = std::sqrt(dot(a_x, a_x));
    if (!(after < before)) break;
    left = after;
    x = std::move(refined);
    r = std::move(a_x);
  }
  return iterations;
}

}  // namespace

SolveReport conjugate_gradient(const BlockSparseMatrix& a, const Preconditioning& preconditioner, const NodeVectors& b,
                               NodeVectors& x, double tolerance, double scale, int max_iterations,
                               const std::function<bool()>& cancelled, const WholeMotion* beside) {
  NodeVectors a_p;
  multiply(a, x, a_p);
  const double guess_energy = dot(x, a_p);
  const double guess_scale = guess_energy > 0 ? dot(x, b) / guess_energy : 0;
  x *= guess_scale;
  NodeVectors r = b - guess_scale * a_p;
  if (beside) r -= beside->momentum_of(r);
  double residual = std::sqrt(dot(r, r));
  const double target = tolerance * scale;

  SolveReport report;
  if (!preconditioner.factors && suits_single_precision(a, tolerance))
    report.iterations = refine_in_single_precision(a, preconditioner.modes, b, target, max_iterations, cancelled,
                                                   beside, x, r, residual);
  DoubleVectors vectors{a, preconditioner, beside, x, r};
  residual = iterate_conjugate_gradients(vectors, residual, target, max_iterations, cancelled, report.iterations);
  if (beside) x -= beside->part_of(x);  // rounding errors of the guess, which its factor may have made large
  report.relative_residual = scale > 0 ? residual / scale : 0;
  report.converged = residual <= target;
  return report;
}

}  // namespace griffith
