#pragma once

#include <optional>

#include "ui/model/view_camera.h"

namespace griffith::ui {

/// How far along the axis (through `origin`, length 1) its point nearest to the ray is [m]; nothing where the ray runs
/// along the axis or the point is behind the eye: a small move would be a jump there.
std::optional<double> nearest_on_axis(const ViewRay& ray, const Vec3& origin, const Vec3& axis);

/// Where the ray meets the plane through `origin`; nothing where it grazes the plane or the plane is behind the eye.
std::optional<Vec3> meet_plane(const ViewRay& ray, const Vec3& origin, const Vec3& normal);

/// How far a ring about `axis` (length 1) is turned by a drag from one ray to another [radians], by half a turn at
/// most where it is seen from its face. A ring
/// that is seen from its edge rolls by the way across the axis. `radius`: of the ring [m].
double ring_turn(const ViewRay& from, const ViewRay& to, const Vec3& center, const Vec3& axis, double radius);

/// The fixed-axis angles of a body turned by `angle` [radians] about the world's axis: those nearest to `degrees`.
Vec3 turned_degrees(const Vec3& degrees, const Vec3& axis, double angle);

/// The largest of …, 0.1, 0.2, 0.5, 1, 2, 5, … that is at most `size` > 0.
double round_step(double size);

}  // namespace griffith::ui
