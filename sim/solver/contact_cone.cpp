#include "sim/solver/contact_cone.h"

#include <cmath>

namespace griffith {

ConeProjection project_on_cone(const Vec3& asked, double friction) {
  const double normal = asked[0], tangential = asked.tail<2>().norm();
  if (tangential <= friction * normal) return {asked, Mat3::Identity()};
  if (friction * tangential <= -normal) return {};
  ConeProjection sliding;
  const Vec2 along = asked.tail<2>() / tangential, across(-along[1], along[0]);
  const Vec3 generator = Vec3(1, friction * along[0], friction * along[1]) / std::sqrt(1 + friction * friction);
  sliding.impulse = generator.dot(asked) * generator;
  sliding.derivative = generator * generator.transpose();
  const double turning = sliding.impulse.tail<2>().norm() / tangential;
  sliding.derivative.bottomRightCorner<2, 2>() += turning * across * across.transpose();
  return sliding;
}

bool sticks(const Vec3& impulse, double friction) {
  constexpr double kOfCone = 1 - 1e-6;
  return impulse[0] > 0 && impulse.tail<2>().norm() <= kOfCone * friction * impulse[0];
}

}  // namespace griffith
