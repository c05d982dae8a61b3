#include "sim/scene/body_pose.h"

#include <numbers>

namespace griffith {

Pose pose_of(const BodyDescription& body) {
  const Vec3 radians = body.rotation_degrees * std::numbers::pi / 180;
  const Quat rotation(Eigen::AngleAxisd(radians.z(), Vec3::UnitZ()) * Eigen::AngleAxisd(radians.y(), Vec3::UnitY()) *
                      Eigen::AngleAxisd(radians.x(), Vec3::UnitX()));
  return {body.position, rotation};
}

}  // namespace griffith
