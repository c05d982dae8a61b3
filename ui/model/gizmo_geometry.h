#pragma once

#include <optional>

#include "ui/model/view_camera.h"

namespace griffith::ui {

/// Returns the coordinate of the point on the axis (through `origin`, direction of length 1) that is nearest to the ray
/// [m]. Empty if the ray is nearly parallel to the axis or the point is behind the eye: a small motion would be a jump
/// there.
std::optional<double> nearest_on_axis(const ViewRay& ray, const Vec3& origin, const Vec3& axis);

/// Returns the intersection of the ray with the plane through `origin`; empty if the ray grazes the plane or the plane
/// is behind the eye.
std::optional<Vec3> meet_plane(const ViewRay& ray, const Vec3& origin, const Vec3& normal);

/// Returns the angle by which a drag from one ray to another rotates a ring about `axis` (length 1) [rad]. Seen face-on
/// the angle is at most half a revolution; seen edge-on the ring rolls with the motion perpendicular to the axis.
/// `radius`: of the ring [m].
double ring_turn(const ViewRay& from, const ViewRay& to, const Vec3& center, const Vec3& axis, double radius);

/// Returns the fixed-axis angles of a body rotated by `angle` [rad] about the world's axis, those nearest to `degrees`.
Vec3 turned_degrees(const Vec3& degrees, const Vec3& axis, double angle);

/// Returns the largest of …, 0.1, 0.2, 0.5, 1, 2, 5, … that is at most `size` > 0.
double round_step(double size);

}  // namespace griffith::ui
