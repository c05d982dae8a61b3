#include "sim/elasticity/placement.h"

#include "sim/elasticity/polar_decomposition.h"

namespace griffith {

Mat3 best_rotation(const Mat3& correlation) {
  const double norm = correlation.norm();
  return polar_rotation(norm > 0 ? Mat3(correlation / norm) : correlation);
}

Placement best_placement(std::span<const Vec3> rest, std::span<const Vec3> now, std::span<const double> weights,
                         std::span<const NodeId> nodes) {
  Placement placement;
  double weight = 0;
  for (const NodeId node : nodes) {
    weight += weights[node];
    placement.center += weights[node] * now[node];
    placement.rest_center += weights[node] * rest[node];
  }
  placement.center /= weight, placement.rest_center /= weight;
  Mat3 correlation = Mat3::Zero();
  for (const NodeId node : nodes)
    correlation += weights[node] * (now[node] - placement.center) * (rest[node] - placement.rest_center).transpose();
  placement.turn = best_rotation(correlation);
  return placement;
}

}  // namespace griffith
