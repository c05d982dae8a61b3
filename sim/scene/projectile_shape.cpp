#include "sim/scene/projectile_shape.h"

#include <Eigen/Eigenvalues>

namespace griffith {

bool span_volume(std::span<const Vec3> points) {
  constexpr double kFlat = 1e-6;
  if (points.size() < 4) return false;
  Vec3 sum = Vec3::Zero();
  for (const Vec3& point : points) sum += point;
  const Vec3 center = sum / static_cast<double>(points.size());
  Mat3 spread = Mat3::Zero();
  for (const Vec3& point : points) spread += (point - center) * (point - center).transpose();
  const Vec3 squares = Eigen::SelfAdjointEigenSolver<Mat3>(spread, Eigen::EigenvaluesOnly).eigenvalues();
  return squares[0] > kFlat * kFlat * squares[2];
}

}  // namespace griffith
