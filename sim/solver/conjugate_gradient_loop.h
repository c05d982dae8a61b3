#pragma once

#include <cmath>
#include <functional>

namespace griffith {

/// The iterations of preconditioned conjugate gradients, whatever vectors are made of. Goes on until the residual's
/// norm `left` is at most `target`, `iterations`, which it counts, are `max_iterations`, `given_up` says so or numbers
/// break down. Returns what is left. `vectors` have
///   precondition()  z becomes P r; returns r·z           turn(f)       p becomes z + f p
///   begin()         p becomes z                          go_along(s)   x += s p, r −= s A p; returns r·r
///   multiply()      finds A p; returns p·A p
template <class Vectors>
double iterate_conjugate_gradients(Vectors& vectors, double left, double target, int max_iterations,
                                   const std::function<bool()>& given_up, int& iterations) {
  double rho = 0;
  for (bool first = true; left > target && iterations < max_iterations && !(given_up && given_up()); first = false) {
    const double previous_rho = rho;
    rho = vectors.precondition();
    first ? vectors.begin() : vectors.turn(rho / previous_rho);
    const double step = rho / vectors.multiply();
    if (!std::isfinite(step)) break;
    left = std::sqrt(vectors.go_along(step));
    ++iterations;
  }
  return left;
}

}  // namespace griffith
