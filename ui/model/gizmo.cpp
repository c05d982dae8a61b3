#include "ui/model/gizmo.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "ui/model/gizmo_geometry.h"
#include "ui/model/gizmo_scale.h"
#include "ui/model/region_outline.h"
#include "ui/model/units.h"

namespace griffith::ui {
namespace {

using Kind = GizmoHandle::Kind;

constexpr double kRingSize = 0.8;                   ///< radius, in lengths of an arrow
constexpr double kQuadNear = 0.3, kQuadFar = 0.52;  ///< edges of plane handles on both axes, in lengths of an arrow
constexpr char kAxisNames[] = "xyz";
constexpr double kDegreesPerRadian = 180 / std::numbers::pi;

Vec3 axis_of(int axis) { return Vec3::Unit(axis); }

/// A gizmo as seen by the camera.
struct Anchor {
  const ViewCamera& camera;
  Vec3 place;
  double length;  ///< length of an arrow [m]
  Vec3 to_eye;    ///< length 1

  /// Returns an axis of the world with the sign that points to the side of the eye.
  Vec3 near_axis(int axis) const { return std::copysign(1, to_eye[axis]) * axis_of(axis); }
};

/// Adds a handle whose outline and grip are relative to the gizmo, in lengths of an arrow.
void add_shape(std::vector<HandleShape>& shapes, const Anchor& anchor, GizmoHandle handle, std::vector<Vec3> outline,
               const Vec3& grip) {
  for (Vec3& point : outline) point = anchor.place + anchor.length * point;
  add_handle(shapes, anchor.camera, handle, outline, anchor.place + anchor.length * grip);
}

/// Returns points of an arc about the origin in the plane of two unit vectors, from one angle to another [rad].
std::vector<Vec3> arc_of(const Vec3& x, const Vec3& y, double radius, double from, double to) {
  constexpr int kSegments = 64;
  std::vector<Vec3> arc;
  for (int i = 0; i <= kSegments; ++i) {
    const double angle = from + (to - from) * i / kSegments;
    arc.push_back(radius * (std::cos(angle) * x + std::sin(angle) * y));
  }
  return arc;
}

void add_arrow(std::vector<HandleShape>& shapes, const Anchor& anchor, int axis) {
  constexpr double kAlongSight = 0.97;  // cosine
  if (std::abs(anchor.to_eye[axis]) > kAlongSight) return;
  add_shape(shapes, anchor, {Kind::arrow, axis}, {0.1 * axis_of(axis), axis_of(axis)}, axis_of(axis));
}

void add_plane(std::vector<HandleShape>& shapes, const Anchor& anchor, int axis) {
  constexpr double kEdgeOn = 0.2;
  if (std::abs(anchor.to_eye[axis]) < kEdgeOn) return;
  const Vec3 a = anchor.near_axis((axis + 1) % 3), b = anchor.near_axis((axis + 2) % 3);
  const std::vector<Vec3> quad = {kQuadNear * (a + b), kQuadFar * a + kQuadNear * b, kQuadFar * (a + b),
                                  kQuadNear * a + kQuadFar * b, kQuadNear * (a + b)};
  add_shape(shapes, anchor, {Kind::plane, axis}, quad, (kQuadNear + kQuadFar) / 2 * (a + b));
}

/// Adds the half of a ring that faces the eye; the full ring if it is seen face-on.
void add_ring(std::vector<HandleShape>& shapes, const Anchor& anchor, int axis) {
  constexpr double kFaceOn = 0.95;
  const Vec3 normal = axis_of(axis);
  const bool whole = std::abs(anchor.to_eye[axis]) > kFaceOn;
  const Vec3 reference = axis_of((axis + 1) % 3);
  const Vec3 front = whole ? reference : (anchor.to_eye - anchor.to_eye[axis] * normal).normalized();
  const Vec3 side = normal.cross(front);
  const double reach = whole ? std::numbers::pi : std::numbers::pi / 2;
  const Vec3 grip = anchor.near_axis((axis + 1) % 3) + anchor.near_axis((axis + 2) % 3);
  add_shape(shapes, anchor, {Kind::ring, axis}, arc_of(front, side, kRingSize, -reach, reach),
            kRingSize * grip.normalized());
}

/// Adds a small circle parallel to the picture in the middle.
void add_center(std::vector<HandleShape>& shapes, const Anchor& anchor) {
  constexpr double kSize = 0.1;
  const ViewCamera& camera = anchor.camera;
  add_shape(shapes, anchor, {Kind::free}, arc_of(camera.right, camera.up, kSize, 0, 2 * std::numbers::pi),
            Vec3::Zero());
}

double distance_to_segment(const Vec2& point, const Vec2& a, const Vec2& b) {
  const Vec2 along = b - a;
  const double length_squared = along.squaredNorm();
  const double t = length_squared > 0 ? std::clamp((point - a).dot(along) / length_squared, 0.0, 1.0) : 0;
  return (a + t * along - point).norm();
}

bool is_inside(const std::vector<Vec2>& polygon, const Vec2& point) {
  bool inside = false;
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
    const Vec2 &a = polygon[i], &b = polygon[j];
    if ((a.y() > point.y()) != (b.y() > point.y()) &&
        point.x() < a.x() + (point.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x()))
      inside = !inside;
  }
  return inside;
}

double distance_to(const HandleShape& shape, const Vec2& point) {
  const std::vector<Vec2>& line = shape.outline;
  if (shape.handle.kind == Kind::plane && is_inside(line, point)) return 0;
  double nearest = (shape.grip - point).norm();
  for (std::size_t i = 1; i < line.size(); ++i)
    nearest = std::min(nearest, distance_to_segment(point, line[i - 1], line[i]));
  return nearest;
}

bool moves(GizmoHandle handle, int axis) {
  return handle.kind == Kind::free || (handle.kind == Kind::arrow) == (handle.axis == axis);
}

/// Returns the displacement from the grabbed point [m].
std::optional<Vec3> offset_of(const GizmoDrag& drag, const ViewRay& ray) {
  const Vec3 &origin = drag.start.position, sight = (origin - drag.grabbed.origin).normalized();
  const Vec3 axis = drag.handle.kind == Kind::free ? sight : axis_of(drag.handle.axis);
  if (drag.handle.kind == Kind::arrow) {
    const auto from = nearest_on_axis(drag.grabbed, origin, axis), to = nearest_on_axis(ray, origin, axis);
    return from && to ? std::optional<Vec3>((*to - *from) * axis) : std::nullopt;
  }
  const auto from = meet_plane(drag.grabbed, origin, axis), to = meet_plane(ray, origin, axis);
  return from && to ? std::optional<Vec3>(*to - *from) : std::nullopt;
}

/// Snaps the position to the nearest contact along an axis of the handle.
void snap_position(GizmoDrag& drag, double reach) {
  for (int axis = 0; axis < 3; ++axis) {
    if (!moves(drag.handle, axis)) continue;
    const Vec3 offset = drag.placement.position - drag.start.position;
    const std::optional<Snap> snap = snap_along(drag.surfaces, offset, axis, reach);
    if (!snap) continue;
    drag.snap = snap;
    drag.placement.position = moved_place(drag.start.position, snap->offset);
  }
}

void move(GizmoDrag& drag, const ViewRay& ray, const DragSteps& steps) {
  drag.snap.reset();
  if (steps.reach > 0 && drag.handle.kind == Kind::free) {
    drag.snap = snap_to_ray(drag.surfaces, drag.start.position, ray);
    if (drag.snap) drag.placement.position = moved_place(drag.start.position, drag.snap->offset);
    if (drag.snap) return;
  }
  const std::optional<Vec3> offset = offset_of(drag, ray);
  if (!offset) return;
  for (int axis = 0; axis < 3; ++axis)
    if (moves(drag.handle, axis))
      drag.placement.position[axis] = multiple_of(drag.start.position[axis] + (*offset)[axis], steps.length);
  if (steps.reach > 0) snap_position(drag, steps.reach);
}

void turn(GizmoDrag& drag, const ViewRay& ray, double step) {
  const Vec3 axis = axis_of(drag.handle.axis);
  drag.angle += ring_turn(drag.last, ray, drag.start.position, axis, drag.radius);
  drag.turn_degrees = multiple_of(drag.angle * kDegreesPerRadian, step);
  drag.placement.rotation_degrees =
      drag.turn_degrees == 0 ? drag.start.rotation_degrees
                             : turned_degrees(drag.start.rotation_degrees, axis, drag.turn_degrees / kDegreesPerRadian);
}

}  // namespace

double multiple_of(double value, double step) {
  if (step >= 1) return std::round(value / step) * step;
  const double inverse = std::round(1 / step);
  return std::round(value * inverse) / inverse;
}

std::string handle_name(GizmoHandle handle) {
  if (handle.kind == Kind::size) return "scale";
  if (handle.kind == Kind::stretch) return std::string("scale_") + kAxisNames[handle.axis];
  if (handle.kind == Kind::ring) return std::string("turn_") + kAxisNames[handle.axis];
  if (handle.kind == Kind::free) return "move";
  std::string name = "move_";
  for (int axis = 0; axis < 3; ++axis)
    if (moves(handle, axis)) name += kAxisNames[axis];
  return name;
}

bool has_effect(const GizmoDrag& drag) { return drag.placement != drag.start || drag.scaling.factors != Vec3::Ones(); }

void add_handle(std::vector<HandleShape>& shapes, const ViewCamera& camera, GizmoHandle handle,
                const std::vector<Vec3>& outline, const Vec3& grip) {
  HandleShape shape{handle, {}, Vec2::Zero()};
  for (const Vec3& point : outline) {
    const std::optional<Vec2> pixel = camera.pixel(point);
    if (!pixel) return;
    shape.outline.push_back(*pixel);
  }
  const std::optional<Vec2> pixel = camera.pixel(grip);
  if (!pixel) return;
  shape.grip = *pixel;
  shapes.push_back(std::move(shape));
}

std::vector<HandleShape> handle_shapes(const ViewCamera& camera, const Vec3& place, double size) {
  std::vector<HandleShape> shapes;
  if (!camera.pixel(place)) return shapes;
  const Anchor anchor{camera, place, size * camera.pixel_length(place), (camera.eye - place).normalized()};
  for (int axis = 0; axis < 3; ++axis) add_arrow(shapes, anchor, axis);
  for (int axis = 0; axis < 3; ++axis) add_plane(shapes, anchor, axis);
  for (int axis = 0; axis < 3; ++axis) add_ring(shapes, anchor, axis);
  add_center(shapes, anchor);
  return shapes;
}

const HandleShape* shape_at(const std::vector<HandleShape>& shapes, const Vec2& pixel, double reach) {
  const HandleShape* nearest = nullptr;
  for (const HandleShape& shape : shapes) {
    const double distance = distance_to(shape, pixel);
    if (distance > reach || (nearest && distance == reach)) continue;
    reach = distance;
    nearest = &shape;
  }
  return nearest;
}

double ring_radius(const ViewCamera& camera, const Vec3& place, double size) {
  return kRingSize * size * camera.pixel_length(place);
}

void follow_ray(GizmoDrag& drag, const ViewRay& ray, const DragSteps& steps) {
  if (ray.origin == drag.last.origin && ray.direction == drag.last.direction && !has_effect(drag)) return;
  if (scales(drag.handle)) {
    follow_scaling(drag, ray, steps);
  } else if (drag.handle.kind == Kind::ring) {
    turn(drag, ray, steps.angle);
  } else {
    move(drag, ray, steps);
  }
  drag.last = ray;
}

std::string drag_text(const GizmoDrag& drag) {
  if (scales(drag.handle)) return scaling_text(drag);
  char number[32];
  if (drag.handle.kind == Kind::ring) {
    std::snprintf(number, sizeof number, "%+.4g°", drag.turn_degrees);
    return std::string("about ") + kAxisNames[drag.handle.axis] + " " + number;
  }
  std::string text;
  for (int axis = 0; axis < 3; ++axis) {
    if (!moves(drag.handle, axis)) continue;
    const double place = drag.placement.position[axis], way = place - drag.start.position[axis];
    text += (text.empty() ? "" : "   ") + std::string(1, kAxisNames[axis]) + " " + format_quantity(place, "m");
    text += (way < 0 ? " (" : " (+") + format_quantity(way, "m") + ")";
  }
  if (drag.snap) text += "   touches " + drag.snap->onto;
  return text;
}

}  // namespace griffith::ui
