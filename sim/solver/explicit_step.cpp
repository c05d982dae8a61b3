#include "sim/solver/explicit_step.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <cstdint>

namespace griffith {
namespace {

/// Returns a start vector without symmetries, the same on every run: every mode has a share in it.
NodeVectors generic_vector(Eigen::Index count) {
  NodeVectors v(3, count);
  std::uint32_t state = 1;
  for (double& component : v.reshaped()) {
    state = 1664525u * state + 1013904223u;  // a linear congruential generator (Numerical Recipes)
    component = static_cast<double>(state) / 4294967296.0 - 0.5;
  }
  return v;
}

}  // namespace

double highest_frequency(const BlockSparseMatrix& stiffness, const Eigen::VectorXd& masses) {
  if (stiffness.rows() == 0) return 0;
  constexpr int kSteps = 30;
  const int steps = std::min<int>(kSteps, 3 * stiffness.rows());
  const Eigen::VectorXd scaling = masses.cwiseSqrt().cwiseInverse();
  Eigen::VectorXd diagonal(steps), off_diagonal(steps);
  NodeVectors previous = NodeVectors::Zero(3, stiffness.rows()), v = generic_vector(stiffness.rows()), product;
  v /= std::sqrt(dot(v, v));
  int done = 0;
  for (double coupling = 0; done < steps;) {
    multiply(stiffness, v * scaling.asDiagonal(), product);
    product = (product * scaling.asDiagonal()).eval();
    product -= coupling * previous;
    diagonal[done] = dot(v, product);
    product -= diagonal[done] * v;
    coupling = off_diagonal[done] = std::sqrt(dot(product, product));
    ++done;
    if (!(coupling > 1e-12 * diagonal[0])) break;  // an invariant subspace: its eigenvalues are exact
    previous = v;
    v = product / coupling;
  }
  Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen;
  eigen.computeFromTridiagonal(diagonal.head(done), off_diagonal.head(done - 1), Eigen::EigenvaluesOnly);
  return std::sqrt(eigen.eigenvalues()[done - 1]);
}

double stable_time_step(double highest_frequency, double stiffness_damping) {
  constexpr double kSafety = 0.9;
  const double damping_ratio = stiffness_damping * highest_frequency / 2;
  // √(1 + ξ²) − ξ in a form that keeps its digits for large ξ.
  return kSafety * 2 / highest_frequency / (std::sqrt(1 + damping_ratio * damping_ratio) + damping_ratio);
}

void explicit_step(double dt, double mass_damping, std::span<const NodeId> nodes,
                   std::span<const NodeConstraint> constraints, std::span<const double> masses,
                   std::span<const Vec3> forces, std::span<Vec3> velocities) {
  for (NodeId node : nodes) {
    const Vec3 change = dt * (forces[node] / masses[node] - mass_damping * velocities[node]);
    velocities[node] = constraints[node].velocity + constraints[node].allowed * (velocities[node] + change);
  }
}

}  // namespace griffith
