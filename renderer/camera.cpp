#include "renderer/camera.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace griffith::render {
namespace {

using Eigen::Vector3f;

constexpr float kRadiansPerDegree = std::numbers::pi_v<float> / 180;
constexpr float kLargestPitch = 89 * kRadiansPerDegree;

/// Orthonormal axes in the world frame.
struct Axes {
  Vector3f right, up, forward;
};

Axes axes(const Camera& camera) {
  const Vector3f forward = (camera.target - camera.position).normalized();
  const bool vertical = std::abs(forward.y()) > 0.9999f;
  const Vector3f world_up = vertical ? Vector3f(0, 0, forward.y() > 0 ? 1 : -1) : Vector3f::UnitY();
  const Vector3f right = forward.cross(world_up).normalized();
  return {right, right.cross(forward), forward};
}

float distance_to_target(const Camera& camera) { return (camera.target - camera.position).norm(); }

float tangent_of_half_angle(const Camera& camera) { return std::tan(0.5f * camera.vertical_fov * kRadiansPerDegree); }

struct DepthRange {
  float near_plane, far_plane;  // [m]
};

DepthRange depth_range(const Camera& camera, const Eigen::AlignedBox3f& bounds) {
  constexpr float kLargestRatio = 1e4f;  // beyond it a 24-bit depth buffer cannot separate surfaces
  const float distance = distance_to_target(camera);
  if (bounds.isEmpty()) return {0.01f * distance, 100 * distance};
  const Vector3f forward = axes(camera).forward;
  const float center = forward.dot(bounds.center() - camera.position);
  const float reach = 0.5f * forward.cwiseAbs().dot(bounds.sizes());
  const float far_plane = std::max(1.01f * (center + reach), 0.1f * distance);
  return {std::clamp(0.99f * (center - reach), far_plane / kLargestRatio, 0.9f * far_plane), far_plane};
}

}  // namespace

Mat4 view_matrix(const Camera& camera) {
  const Axes frame = axes(camera);
  Eigen::Matrix3f rotation;
  rotation << frame.right.transpose(), frame.up.transpose(), -frame.forward.transpose();
  Mat4 view = Mat4::Identity();
  view.topLeftCorner<3, 3>() = rotation;
  view.topRightCorner<3, 1>() = -rotation * camera.position;
  return view;
}

Mat4 projection_matrix(const Camera& camera, float aspect, const Eigen::AlignedBox3f& bounds) {
  const auto [near_plane, far_plane] = depth_range(camera, bounds);
  const float cotangent = 1 / tangent_of_half_angle(camera);
  Mat4 projection = Mat4::Zero();
  projection(0, 0) = cotangent / aspect;
  projection(1, 1) = cotangent;
  projection(2, 2) = (far_plane + near_plane) / (near_plane - far_plane);
  projection(2, 3) = 2 * far_plane * near_plane / (near_plane - far_plane);
  projection(3, 2) = -1;
  return projection;
}

Camera orbit(const Camera& camera, float yaw, float pitch) {
  const Vector3f offset = camera.position - camera.target;
  const float distance = offset.norm();
  const float azimuth = std::atan2(offset.x(), offset.z()) + yaw;
  const float elevation =
      std::clamp(std::asin(std::clamp(offset.y() / distance, -1.0f, 1.0f)) + pitch, -kLargestPitch, kLargestPitch);
  const Vector3f direction(std::cos(elevation) * std::sin(azimuth), std::sin(elevation),
                           std::cos(elevation) * std::cos(azimuth));
  Camera turned = camera;
  turned.position = camera.target + distance * direction;
  return turned;
}

float height_at_target(const Camera& camera) { return 2 * distance_to_target(camera) * tangent_of_half_angle(camera); }

Camera contain(const Camera& camera, float shown, float aspect) {
  constexpr float kWidest = 120;
  if (aspect >= shown) return camera;
  Camera wide = camera;
  const float angle = 2 * std::atan(tangent_of_half_angle(camera) * shown / aspect) / kRadiansPerDegree;
  wide.vertical_fov = std::min(angle, std::max(kWidest, camera.vertical_fov));
  return wide;
}

Camera widen(const Camera& camera, float aspect) { return contain(camera, 16.0f / 9, aspect); }

Camera pan(const Camera& camera, float right, float up) {
  const Axes frame = axes(camera);
  const Vector3f shift = height_at_target(camera) * (right * frame.right + up * frame.up);
  Camera moved = camera;
  moved.position += shift;
  moved.target += shift;
  return moved;
}

Camera zoom(const Camera& camera, float factor) {
  Camera moved = camera;
  moved.position = camera.target + factor * (camera.position - camera.target);
  return moved;
}

Camera frame_bounds(const Camera& camera, const Eigen::AlignedBox3f& bounds, float aspect) {
  if (bounds.isEmpty()) return camera;
  constexpr float kMargin = 1.05f, kSmallestRadius = 1e-4f;
  const float radius = std::max(0.5f * bounds.sizes().norm(), kSmallestRadius);
  const float half_angle = std::atan(tangent_of_half_angle(camera) * std::min(1.0f, aspect));
  Camera framed = camera;
  framed.target = bounds.center();
  framed.position = framed.target - kMargin * radius / std::sin(half_angle) * axes(camera).forward;
  return framed;
}

bool shows(const Camera& camera, const Eigen::AlignedBox3f& box, float aspect) {
  const Axes eye = axes(camera);
  for (int i = 0; i < 8; ++i) {
    const Vector3f way = box.corner(static_cast<Eigen::AlignedBox3f::CornerType>(i)) - camera.position;
    const float reach = eye.forward.dot(way) * tangent_of_half_angle(camera);  // half the picture's height there
    if (std::abs(eye.up.dot(way)) > reach || std::abs(eye.right.dot(way)) > aspect * reach) return false;
  }
  return true;
}

Camera far_camera(const Camera& camera, const Eigen::Vector3f& toward_eye) {
  Camera seen{camera.target, camera.target, 2};
  seen.position += 0.5f * height_at_target(camera) / tangent_of_half_angle(seen) * toward_eye;
  return seen;
}

Ray pixel_ray(const Camera& camera, float x, float y, int width, int height) {
  const Axes frame = axes(camera);
  const float per_pixel = 2 * tangent_of_half_angle(camera) / static_cast<float>(height);
  const float right = (x - 0.5f * static_cast<float>(width)) * per_pixel;
  const float up = (0.5f * static_cast<float>(height) - y) * per_pixel;
  return {camera.position, (frame.forward + right * frame.right + up * frame.up).normalized()};
}

}  // namespace griffith::render
