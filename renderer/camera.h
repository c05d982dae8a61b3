#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace griffith::render {

/// A perspective camera that looks from `position` at `target`; up is +Y (-Z or +Z if it looks straight down or up).
struct Camera {
  Eigen::Vector3f position = {3, 2, 4};   ///< [m]
  Eigen::Vector3f target = {0, 0.5f, 0};  ///< [m]; center of orbit and zoom
  float vertical_fov = 40;                ///< full angle [degrees], in (0, 180)
};

/// A ray: points origin + t · direction, t ≥ 0; direction has length 1.
struct Ray {
  Eigen::Vector3f origin, direction;
};

using Mat4 = Eigen::Matrix<float, 4, 4, Eigen::DontAlign>;  // packed as in std140

/// Returns the transform from world to eye (right-handed, looking down −z).
Mat4 view_matrix(const Camera& camera);

/// Returns the transform from eye to clip space (OpenGL convention). Near and far planes enclose `bounds`, which may be
/// empty.
Mat4 projection_matrix(const Camera& camera, float aspect, const Eigen::AlignedBox3f& bounds);

/// Rotates the camera about its target: `yaw` about the vertical (positive: the camera moves to its right), `pitch`
/// toward the zenith [rad]; stops short of the poles. The distance to the target stays.
Camera orbit(const Camera& camera, float yaw, float pitch);

/// Returns the height of the view at the target [m].
float height_at_target(const Camera& camera);

/// Widens the field of view so that a picture narrower than 16:9 shows the same width as one of that shape, up to 120°.
Camera widen(const Camera& camera, float aspect);

/// Widens the field of view, up to 120°, so that a picture of shape `aspect` (width over height) contains all of one of
/// shape `shown`.
Camera contain(const Camera& camera, float shown, float aspect);

/// Moves camera and target in the image plane, in units of the image's height at the target.
Camera pan(const Camera& camera, float right, float up);

/// Multiplies the distance to the target by `factor` > 0: below 1 zooms in.
Camera zoom(const Camera& camera, float factor);

/// Returns the camera with the same line of sight, its target at the center of `bounds` and all of the bounding sphere
/// in the picture. An empty box changes nothing.
Camera frame_bounds(const Camera& camera, const Eigen::AlignedBox3f& bounds, float aspect);

/// True if all of a box, which is not empty, is in a picture of shape `aspect`.
bool shows(const Camera& camera, const Eigen::AlignedBox3f& box, float aspect);

/// Returns a camera with the same target and the same height of the view there, whose eye is in the given direction,
/// of length 1. It is so far away that its picture is nearly a parallel projection.
Camera far_camera(const Camera& camera, const Eigen::Vector3f& toward_eye);

/// Returns the ray through a point of a width × height image, in pixels from its top left corner (pixel centers at
/// halves).
Ray pixel_ray(const Camera& camera, float x, float y, int width, int height);

}  // namespace griffith::render
