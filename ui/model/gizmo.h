#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "ui/model/scene_entry.h"
#include "ui/model/view_camera.h"

namespace griffith::ui {

/// What of a gizmo is dragged.
struct GizmoHandle {
  enum class Kind { arrow, plane, ring };  ///< moves along the axis, moves across it, turns about it
  Kind kind = Kind::arrow;
  int axis = 0;  ///< of the world
  bool operator==(const GizmoHandle&) const = default;
};

/// "move_x", "move_yz", "turn_x".
std::string handle_name(GizmoHandle handle);

/// A handle as it is seen.
struct HandleShape {
  GizmoHandle handle;
  std::vector<Vec2> outline;  ///< a line in the picture [pixels]; that of a plane is closed
  Vec2 grip;                  ///< a point of it away from the others
};

/// The handles round a place, arrows `size` pixels long; without those that cannot be dragged as they are seen, and
/// without any where the place is not before the eye.
std::vector<HandleShape> handle_shapes(const ViewCamera& camera, const Vec3& place, double size);

/// The shape nearest to the pixel, among those no farther than `reach` [pixels]; or nullptr.
const HandleShape* shape_at(const std::vector<HandleShape>& shapes, const Vec2& pixel, double reach);

/// Of the rings there [m].
double ring_radius(const ViewCamera& camera, const Vec3& place, double size);

/// Where an entry of a scene stands, as the scene says it.
struct Placement {
  Vec3 position = Vec3::Zero(), rotation_degrees = Vec3::Zero();
  bool operator==(const Placement&) const = default;
};

/// A handle in the user's hand.
struct GizmoDrag {
  GizmoHandle handle;
  SceneEntry entry;            ///< of the scene
  std::int64_t revision = 0;   ///< of the scene, as it was grabbed
  Placement start, placement;  ///< as it was grabbed, and as it would be if let go now
  ViewRay grabbed, last;       ///< under the cursor
  double radius = 1;           ///< of rings [m]
  double angle = 0;            ///< that the cursor has gone about the ring [radians]
  double turn_degrees = 0;     ///< that the entry is turned by for it
  Eigen::AlignedBox3d box;     ///< round a body, in its rest space [m]; of others empty
  bool cancelled = false;      ///< until the button is released
};

/// A part of a region in the user's hand, such as a face of its box.
struct RegionDrag {
  SceneEntry entry;           ///< whose region it is
  std::size_t grip = 0;       ///< which part, by region_grips()
  std::int64_t revision = 0;  ///< of the scene, as it was grabbed
  Region start, region;       ///< as it was grabbed, and as it would be if let go now
  ViewRay grabbed;            ///< under the cursor
  bool cancelled = false;     ///< until the button is released
};

/// What coordinates become multiples of [m], and turns [degrees].
struct DragSteps {
  double length = 1e-3, angle = 0.1;  ///< > 0
};

/// Moves or turns with the cursor's ray. Coordinates that the handle does not move stay as they are to the bit, and so
/// does all while the ray says nothing.
void follow_ray(GizmoDrag& drag, const ViewRay& ray, const DragSteps& steps);

/// The multiple of `step` > 0 next to the value; exact where the step is 1 over a whole number.
double multiple_of(double value, double step);

/// "x 1.25 m (+0.25 m)", "about y +15°".
std::string drag_text(const GizmoDrag& drag);

}  // namespace griffith::ui
