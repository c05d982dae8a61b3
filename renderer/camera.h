#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace griffith::render {

/// A perspective camera that looks from `position` at `target`; up is +Y (-Z or +Z where it looks
/// straight down or up).
struct Camera {
  Eigen::Vector3f position = {3, 2, 4};   ///< [m]
  Eigen::Vector3f target = {0, 0.5f, 0};  ///< [m]; orbits and zooms are about it
  float vertical_fov = 40;                ///< full angle [degrees], in (0, 180)
};

/// A half-line: points origin + t · direction, t ≥ 0; direction has length 1.
struct Ray {
  Eigen::Vector3f origin, direction;
};

using Mat4 = Eigen::Matrix<float, 4, 4, Eigen::DontAlign>;  // packed as in std140

/// World to eye (right-handed, looking down −z).
Mat4 view_matrix(const Camera& camera);

/// Eye to clip space (OpenGL convention). Near and far planes enclose `bounds`, which may be empty.
Mat4 projection_matrix(const Camera& camera, float aspect, const Eigen::AlignedBox3f& bounds);

/// Turns about the target: `yaw` about the vertical (positive: the camera moves to its right), `pitch` towards the
/// zenith [radians]; stops short of the poles. The distance to the target stays.
Camera orbit(const Camera& camera, float yaw, float pitch);

/// How high the part of the picture's plane through the target is that the picture shows [m].
float height_at_target(const Camera& camera);

/// Opened so far that a picture narrower than 16:9 shows as much across as one of that shape, up to 120°.
Camera widen(const Camera& camera, float aspect);

/// Moves camera and target in the image plane, in units of the image's height at the target.
Camera pan(const Camera& camera, float right, float up);

/// Multiplies the distance to the target by `factor` > 0: below 1 comes closer.
Camera zoom(const Camera& camera, float factor);

/// The same line of sight, target in the middle of `bounds` and all of its bounding sphere in the picture. An empty box
/// changes nothing.
Camera frame_bounds(const Camera& camera, const Eigen::AlignedBox3f& bounds, float aspect);

/// The ray through a point of a width × height image, in pixels from its top left corner (pixel centres at halves).
Ray pixel_ray(const Camera& camera, float x, float y, int width, int height);

}  // namespace griffith::render
