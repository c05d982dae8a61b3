#include "sim/solver/node_constraint.h"

#include <Eigen/Eigenvalues>
#include <cassert>

namespace griffith {

NodeConstraint NodeConstraint::held(const Vec3& velocity) { return {Mat3::Zero(), velocity, 3}; }

NodeConstraint NodeConstraint::sliding(const Vec3& normal, double speed) {
  NodeConstraint constraint;
  constraint.block(normal, speed);
  return constraint;
}

void NodeConstraint::block(const Vec3& direction, double speed) {
  assert(direction.norm() > 0);
  constexpr double kParallel = 1e-6;  // sine of the angle below which a direction counts as blocked already
  const Vec3 normal = direction.normalized();
  const Vec3 open = allowed * normal;
  const double fraction = open.norm();
  if (fraction < kParallel) return;
  const Vec3 axis = open / fraction;
  velocity += (speed - normal.dot(velocity)) / fraction * axis;
  ++blocked;
  allowed = blocked == 3 ? Mat3(Mat3::Zero()) : Mat3(allowed - axis * axis.transpose());
}

NodeConstraint constraint_between(const NodeConstraint& a, const NodeConstraint& b) {
  if (a.is_free() || b.is_free()) return {};
  if (a.is_held() && b.is_held()) return NodeConstraint::held();
  constexpr double kNone = 1e-9;  // of a direction that either end may take
  const Eigen::SelfAdjointEigenSolver<Mat3> directions(a.allowed + b.allowed);
  NodeConstraint between;
  for (int i = 0; i < 3; ++i)
    if (directions.eigenvalues()[i] < kNone) between.block(directions.eigenvectors().col(i), 0);
  return between;
}

}  // namespace griffith
