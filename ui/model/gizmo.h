#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "ui/model/entry_scale.h"
#include "ui/model/scene_entry.h"
#include "ui/model/snap.h"
#include "ui/model/view_camera.h"

namespace griffith::ui {

/// Handles that are shown in the view.
enum class GizmoTool {
  none,
  place,  ///< move and rotate
  scale,
};

/// Handle of a gizmo.
struct GizmoHandle {
  enum class Kind {
    arrow,    ///< moves along the axis
    plane,    ///< moves perpendicular to the axis
    free,     ///< moves parallel to the picture
    ring,     ///< rotates about the axis
    stretch,  ///< scales along the axis
    size,     ///< scales equally along all axes
  };
  Kind kind = Kind::arrow;
  int axis = 0;  ///< 0..2: axis of the world; for `stretch` of the entry itself
  bool operator==(const GizmoHandle&) const = default;
};

/// Returns the name of a handle: "move_x", "move_yz", "move", "turn_x", "scale_x", "scale".
std::string handle_name(GizmoHandle handle);

/// A handle as drawn.
struct HandleShape {
  GizmoHandle handle;
  std::vector<Vec2> outline;  ///< polyline in the picture [pixels]; closed for a plane
  Vec2 grip;                  ///< point of the handle away from the other handles
};

/// Adds a handle with an outline and a grip in the world [m], if all of it is in front of the eye.
void add_handle(std::vector<HandleShape>& shapes, const ViewCamera& camera, GizmoHandle handle,
                const std::vector<Vec3>& outline, const Vec3& grip);

/// Returns the handles that move and rotate at a place, with arrows `size` pixels long. Leaves out handles that cannot
/// be dragged from this view; empty if the place is behind the eye.
std::vector<HandleShape> handle_shapes(const ViewCamera& camera, const Vec3& place, double size);

/// Returns the shape nearest to the pixel within `reach` [pixels], or nullptr.
const HandleShape* shape_at(const std::vector<HandleShape>& shapes, const Vec2& pixel, double reach);

/// Returns the radius of the rings at a place [m].
double ring_radius(const ViewCamera& camera, const Vec3& place, double size);

/// Placement of a scene entry, as the scene file gives it.
struct Placement {
  Vec3 position = Vec3::Zero(), rotation_degrees = Vec3::Zero();
  bool operator==(const Placement&) const = default;
};

/// Scaling of an entry by a drag.
struct Scaling {
  ScaleFrame frame;             ///< axes and size at the start
  Vec3 factors = Vec3::Ones();  ///< along its axes
};

/// A handle being dragged.
struct GizmoDrag {
  GizmoHandle handle;
  SceneEntry entry;               ///< dragged entry
  std::int64_t revision = 0;      ///< revision of the scene at the start
  Placement start, placement;     ///< at the start of the drag, and now
  ViewRay grabbed, last;          ///< rays under the cursor at the start and now
  double radius = 1;              ///< radius of the rings [m]
  double angle = 0;               ///< angle that the cursor has covered about the ring [rad]
  double turn_degrees = 0;        ///< resulting rotation of the entry [degrees]
  SnapScene surfaces = {};        ///< surfaces that a move can snap to
  std::optional<Snap> snap = {};  ///< contact that it has snapped to
  Scaling scaling = {};           ///< while a handle that scales is dragged
  Eigen::AlignedBox3d box;        ///< bounding box of a body in its rest space [m]; empty for other entries
  bool cancelled = false;         ///< ignored until the button is released
};

/// A grip of a region being dragged, such as a face of its box.
struct RegionDrag {
  SceneEntry entry;           ///< entry with the region
  std::size_t grip = 0;       ///< index into region_grips()
  std::int64_t revision = 0;  ///< revision of the scene at the start
  Region start, region;       ///< at the start of the drag, and now
  ViewRay grabbed;            ///< ray under the cursor at the start
  bool cancelled = false;     ///< ignored until the button is released
};

/// Increments of coordinates and sizes [m], rotations [degrees] and factors [-].
struct DragSteps {
  double length = 1e-3, angle = 0.1, factor = 0.01;  ///< > 0
  double reach = 0;                                  ///< distance at which a move snaps to surfaces [m]; 0: it does not
};

/// True if the drag has changed anything.
bool has_effect(const GizmoDrag& drag);

/// Moves, rotates or scales with the cursor's ray. Coordinates that the handle does not move keep their bits, as
/// does everything if the ray has no solution.
void follow_ray(GizmoDrag& drag, const ViewRay& ray, const DragSteps& steps);

/// Returns the multiple of `step` > 0 nearest to the value; exact if the step is 1 over an integer.
double multiple_of(double value, double step);

/// Describes the drag: "x 1.25 m (+0.25 m)", "about y +15°", "x 0.75 m (× 1.5)".
std::string drag_text(const GizmoDrag& drag);

}  // namespace griffith::ui
