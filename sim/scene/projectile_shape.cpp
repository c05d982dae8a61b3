#include "sim/scene/projectile_shape.h"

#include <Eigen/SVD>

namespace griffith {

bool span_volume(std::span<const Vec3> points) {
  constexpr double kFlat = 1e-6;
  if (points.size() < 4) return false;
  const Eigen::Map<const Eigen::Matrix3Xd> columns(points.front().data(), 3, static_cast<Eigen::Index>(points.size()));
  const Eigen::Matrix3Xd spread = columns.colwise() - columns.rowwise().mean();
  const Vec3 extents = Eigen::JacobiSVD<Eigen::MatrixXd>(spread).singularValues();
  return extents[2] > kFlat * extents[0];
}

}  // namespace griffith
