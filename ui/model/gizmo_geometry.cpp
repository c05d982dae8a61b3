#include "ui/model/gizmo_geometry.h"

#include <cmath>
#include <numbers>

#include "sim/scene/body_pose.h"

namespace griffith::ui {
namespace {

constexpr double kDegrees = 180 / std::numbers::pi;
constexpr double kGrazing = 0.05;  ///< sine of the angle below which rays and axes or planes count as parallel

/// Returns equivalent angles, each within half a revolution of `reference`.
Vec3 near(const Vec3& degrees, const Vec3& reference) {
  return degrees.binaryExpr(reference,
                            [](double angle, double near) { return near + std::remainder(angle - near, 360); });
}

/// Rounds away digits that come from rounding errors alone.
Vec3 rounded(const Vec3& degrees) {
  constexpr double kParts = 1e6;
  return degrees.unaryExpr([](double angle) { return std::round(angle * kParts) / kParts; });
}

}  // namespace

std::optional<double> nearest_on_axis(const ViewRay& ray, const Vec3& origin, const Vec3& axis) {
  const Vec3 arm = origin - ray.origin;
  const double cosine = axis.dot(ray.direction), sine_squared = 1 - cosine * cosine;
  if (sine_squared < kGrazing * kGrazing) return std::nullopt;
  const double along = (cosine * ray.direction - axis).dot(arm) / sine_squared;
  if ((arm + along * axis).dot(ray.direction) <= 0) return std::nullopt;
  return along;
}

std::optional<Vec3> meet_plane(const ViewRay& ray, const Vec3& origin, const Vec3& normal) {
  const double slope = ray.direction.dot(normal);
  if (std::abs(slope) < kGrazing) return std::nullopt;
  const double way = (origin - ray.origin).dot(normal) / slope;
  if (way <= 0) return std::nullopt;
  return ray.origin + way * ray.direction;
}

double ring_turn(const ViewRay& from, const ViewRay& to, const Vec3& center, const Vec3& axis, double radius) {
  constexpr double kEdgeOn = 0.25;
  const Vec3 sight = (center - from.origin).normalized();
  const bool faces = std::abs(sight.dot(axis)) > kEdgeOn;
  const Vec3 normal = faces ? axis : sight;
  const std::optional<Vec3> start = meet_plane(from, center, normal), end = meet_plane(to, center, normal);
  if (!start || !end) return 0;
  if (!faces) return (*end - *start).dot(sight.cross(axis).normalized()) / radius;
  const Vec3 a = *start - center, b = *end - center;
  return std::atan2(axis.dot(a.cross(b)), a.dot(b));
}

Vec3 turned_degrees(const Vec3& degrees, const Vec3& axis, double angle) {
  constexpr double kLocked = 1e-7;  // cosine of y below which x and z rotate about the same axis (gimbal lock)
  const Mat3 turn = (Eigen::AngleAxisd(angle, axis) * rotation_of(degrees)).toRotationMatrix();
  const double cosine = std::hypot(turn(0, 0), turn(1, 0)), y = std::atan2(-turn(2, 0), cosine);
  if (cosine < kLocked) {
    const double x = degrees.x() / kDegrees, z = std::atan2(-turn(0, 1), turn(1, 1)) + (y > 0 ? x : -x);
    return rounded(near(kDegrees * Vec3(x, y, z), degrees));
  }
  const Vec3 angles = kDegrees * Vec3(std::atan2(turn(2, 1), turn(2, 2)), y, std::atan2(turn(1, 0), turn(0, 0)));
  const Vec3 one = near(angles, degrees),
             other = near(Vec3(angles.x() + 180, 180 - angles.y(), angles.z() + 180), degrees);
  return rounded((one - degrees).norm() <= (other - degrees).norm() ? one : other);
}

double round_step(double size) {
  const double decade = std::pow(10, std::floor(std::log10(size)));
  for (const double digit : {5.0, 2.0})
    if (digit * decade <= size) return digit * decade;
  return decade;
}

}  // namespace griffith::ui
