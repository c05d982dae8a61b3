#include "sim/solver/conjugate_gradient.h"

#include <cmath>

namespace griffith {

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
    preconditioner.apply(r, z);
    const double previous_rho = rho;
    rho = dot(r, z);
    if (report.iterations == 0) {
      p = z;
    } else {
      p = z + (rho / previous_rho) * p;
    }
    multiply(a, p, a_p);
    const double step = rho / dot(p, a_p);
    if (!std::isfinite(step)) break;
    x += step * p;
    r -= step * a_p;
    residual = std::sqrt(dot(r, r));
    ++report.iterations;
  }
  report.relative_residual = scale > 0 ? residual / scale : 0;
  report.converged = residual <= target;
  return report;
}

}  // namespace griffith
