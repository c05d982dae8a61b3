#include "ui/model/gizmo_scale.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "ui/model/gizmo_geometry.h"
#include "ui/model/units.h"

namespace griffith::ui {
namespace {

using Kind = GizmoHandle::Kind;

constexpr double kOuterRing = 1.3;                          ///< radius of the handle of all axes, in lengths of others
constexpr double kSmallestSize = 2e-4, kLargestSize = 1e5;  ///< lengths in scenes [m]
constexpr double kSmallestFactor = 1e-3, kLargestFactor = 1e3;
constexpr char kOwnAxes[] = "xyz";

/// Adds a ring parallel to the picture.
void add_outer_ring(std::vector<HandleShape>& shapes, const ViewCamera& camera, const Vec3& place, double radius) {
  constexpr int kSegments = 64;
  std::vector<Vec3> circle;
  for (int i = 0; i <= kSegments; ++i) {
    const double angle = 2 * std::numbers::pi * i / kSegments;
    circle.push_back(place + radius * (std::cos(angle) * camera.right + std::sin(angle) * camera.up));
  }
  add_handle(shapes, camera, {Kind::size}, circle, place + radius * (camera.right + camera.up).normalized());
}

/// Returns the ratio of the cursor's distances from the place, now and at the start; empty if a ray has no solution.
std::optional<double> ratio_of(const GizmoDrag& drag, const ViewRay& ray) {
  const Vec3& place = drag.start.position;
  if (drag.handle.kind == Kind::stretch) {
    const Vec3 axis = drag.scaling.frame.axes.col(drag.handle.axis);
    const auto from = nearest_on_axis(drag.grabbed, place, axis), to = nearest_on_axis(ray, place, axis);
    return from && to && *from != 0 ? std::optional(*to / *from) : std::nullopt;
  }
  const Vec3 sight = (place - drag.grabbed.origin).normalized();
  const auto from = meet_plane(drag.grabbed, place, sight), to = meet_plane(ray, place, sight);
  return from && to ? std::optional((*to - place).norm() / (*from - place).norm()) : std::nullopt;
}

/// Returns the factor at which the length along the handle's axis is a multiple of the step; without a known length
/// that of the factor's step.
double rounded_factor(const GizmoDrag& drag, double ratio, const DragSteps& steps) {
  const std::optional<Vec3>& extents = drag.scaling.frame.extents;
  if (drag.handle.kind == Kind::size || !extents || (*extents)[drag.handle.axis] <= 0)
    return std::clamp(multiple_of(ratio, steps.factor), std::max(kSmallestFactor, steps.factor), kLargestFactor);
  const double length = (*extents)[drag.handle.axis];
  return std::clamp(multiple_of(length * ratio, steps.length), steps.length, kLargestFactor * length) / length;
}

/// Returns the factor within the range in which all lengths can be in a scene.
double in_range(const ScaleFrame& frame, double factor) {
  if (!frame.extents || frame.extents->minCoeff() <= 0) return factor;
  return std::clamp(factor, std::min(1.0, kSmallestSize / frame.extents->minCoeff()),
                    std::max(1.0, kLargestSize / frame.extents->maxCoeff()));
}

bool moves_with(const GizmoDrag& drag, int axis) {
  const ScaleGroups& groups = drag.scaling.frame.groups;
  return drag.handle.kind == Kind::size ||
         groups[static_cast<std::size_t>(axis)] == groups[static_cast<std::size_t>(drag.handle.axis)];
}

}  // namespace

bool scales(GizmoHandle handle) { return handle.kind == Kind::stretch || handle.kind == Kind::size; }

std::vector<HandleShape> scale_shapes(const ViewCamera& camera, const Vec3& place, double size,
                                      const ScaleFrame& frame) {
  constexpr double kAlongSight = 0.97;  // cosine
  std::vector<HandleShape> shapes;
  if (!camera.pixel(place)) return shapes;
  const double length = size * camera.pixel_length(place);
  const Vec3 to_eye = (camera.eye - place).normalized();
  for (int axis = 0; axis < 3; ++axis) {
    const Vec3 along = length * frame.axes.col(axis);
    if (std::abs(to_eye.dot(frame.axes.col(axis))) > kAlongSight) continue;
    add_handle(shapes, camera, {Kind::stretch, axis}, {place + 0.2 * along, place + along}, place + along);
  }
  add_outer_ring(shapes, camera, place, kOuterRing * length);
  return shapes;
}

void follow_scaling(GizmoDrag& drag, const ViewRay& ray, const DragSteps& steps) {
  const std::optional<double> ratio = ratio_of(drag, ray);
  if (!ratio) return;
  const double factor = in_range(drag.scaling.frame, rounded_factor(drag, *ratio, steps));
  for (int axis = 0; axis < 3; ++axis)
    if (moves_with(drag, axis)) drag.scaling.factors[axis] = factor;
}

std::string scaling_text(const GizmoDrag& drag) {
  const auto& [frame, factors] = drag.scaling;
  std::string text;
  for (int axis = 0; axis < 3; ++axis) {
    if (!moves_with(drag, axis)) continue;
    text += (text.empty() ? "" : "   ") + std::string(1, kOwnAxes[axis]);
    if (frame.extents) text += " " + format_quantity((*frame.extents)[axis] * factors[axis], "m");
  }
  char number[32];
  std::snprintf(number, sizeof number, "   (× %.4g)", factors[drag.handle.axis]);
  return text + number;
}

}  // namespace griffith::ui
