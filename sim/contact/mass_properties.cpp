#include "sim/contact/mass_properties.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>

namespace griffith {

MassProperties mass_properties(const ConvexHull& hull) {
  // Tets from the first corner to each triangle of the faces: ∫ x xᵀ = V/20 (Σ a aᵀ + Σa Σaᵀ), a the corners from
  // there.
  MassProperties solid;
  Vec3 moment = Vec3::Zero();
  Mat3 second = Mat3::Zero();
  const Vec3& origin = hull.corners.front();
  for (const std::vector<int>& face : hull.faces)
    for (std::size_t i = 2; i < face.size(); ++i) {
      Mat3 arms;
      arms << hull.corners[face[0]] - origin, hull.corners[face[i - 1]] - origin, hull.corners[face[i]] - origin;
      const double volume = arms.determinant() / 6;
      const Vec3 sum = arms.rowwise().sum();
      solid.volume += volume;
      moment += volume / 4 * sum;
      second += volume / 20 * (arms * arms.transpose() + sum * sum.transpose());
    }
  const Vec3 center = moment / solid.volume;
  second -= solid.volume * center * center.transpose();
  solid.center = origin + center;
  solid.inertia = second.trace() * Mat3::Identity() - second;
  return solid;
}

bool is_solid(const ConvexHull& hull) {
  constexpr double kFlat = 1e-9;
  Eigen::AlignedBox3d box;
  for (const Vec3& corner : hull.corners) box.extend(corner);
  return hull.corners.size() >= 4 && hull.volume > kFlat * std::pow(box.diagonal().norm(), 3);
}

}  // namespace griffith
