#pragma once

#include <cmath>
#include <functional>

namespace griffith {

/// Iterates preconditioned conjugate gradients for any type of vectors. Ends when the residual's norm `left` is at most
/// `target`, `iterations`, which it counts, are `max_iterations`, `cancelled` returns true or numbers break down.
/// Returns the residual's norm. `vectors` have
///   precondition()  z becomes P r; returns r·z           update_direction(f)   p becomes z + f p
///   begin()         p becomes z                          advance_solution(s)   x += s p, r −= s A p; returns r·r
///   multiply()      finds A p; returns p·A p
template <class Vectors>
double iterate_conjugate_gradients(Vectors& vectors, double left, double target, int max_iterations,
                                   const std::function<bool()>& cancelled, int& iterations) {
  double rho = 0;
  for (bool first = true; left > target && iterations < max_iterations && !(cancelled && cancelled()); first = false) {
    const double previous_rho = rho;
    rho = vectors.precondition();
    first ? vectors.begin() : vectors.update_direction(rho / previous_rho);
    const double step = rho / vectors.multiply();
    if (!std::isfinite(step)) break;
    left = std::sqrt(vectors.advance_solution(step));
    ++iterations;
  }
  return left;
}

}  // namespace griffith
