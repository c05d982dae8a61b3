#include "sim/scene/body_pose.h"

#include <numbers>

namespace griffith {

Quat rotation_of(const Vec3& degrees) {
  const Vec3 radians = degrees * std::numbers::pi / 180;
  return Quat(Eigen::AngleAxisd(radians.z(), Vec3::UnitZ()) * Eigen::AngleAxisd(radians.y(), Vec3::UnitY()) *
              Eigen::AngleAxisd(radians.x(), Vec3::UnitX()));
}

Pose pose_of(const BodyDescription& body) { return {body.position, rotation_of(body.rotation_degrees)}; }

}  // namespace griffith
