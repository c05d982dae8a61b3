#include "sim/solver/contact_cone.h"

#include <algorithm>
#include <cmath>

namespace griffith {
namespace {

ConeProjection project_on_whole_cone(const Vec3& asked, double friction) {
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

/// Projects onto the disc in which a plane cuts the cone.
ConeProjection project_on_disc(const Vec3& asked, double radius, double normal) {
  const double tangential = asked.tail<2>().norm();
  ConeProjection found;
  found.impulse = Vec3(normal, asked[1], asked[2]);
  found.derivative.bottomRightCorner<2, 2>().setIdentity();
  if (tangential <= radius) return found;
  const Vec2 along = asked.tail<2>() / tangential, across(-along[1], along[0]);
  found.impulse.tail<2>() = radius * along;
  found.derivative.bottomRightCorner<2, 2>() = radius / tangential * across * across.transpose();
  return found;
}

}  // namespace

ConeProjection project_on_cone(const Vec3& asked, double friction, double least) {
  const ConeProjection found = project_on_whole_cone(asked, friction);
  return found.impulse[0] < least ? project_on_disc(asked, friction * least, least) : found;
}

ConeProjection hold_back(const Vec3& asked, double slack, double strength) {
  const double whole = asked.norm(), beyond = whole - slack;
  if (beyond <= 0) return {};
  const double taken = std::min(beyond, strength);
  const Vec3 along = asked / whole;
  ConeProjection held{taken * along, taken / whole * Mat3::Identity()};
  held.derivative += ((beyond < strength ? 1 : 0) - taken / whole) * along * along.transpose();
  return held;
}

bool sticks(const Vec3& impulse, double friction) {
  constexpr double kOfCone = 1 - 1e-6;
  return impulse[0] > 0 && impulse.tail<2>().norm() <= kOfCone * friction * impulse[0];
}

}  // namespace griffith
