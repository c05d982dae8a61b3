#include <cmath>
#include <string>

#include "sim/scene/body_pose.h"
#include "ui/model/entry_place.h"
#include "ui/model/gizmo_geometry.h"
#include "ui/model/units.h"
#include "ui/panels/chosen_region.h"
#include "ui/panels/overlays.h"
#include "ui/panels/view_drawing.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace griffith::ui {
namespace {

constexpr float kGripSize = 5;  // half an edge, design pixels
constexpr double kMinRadius = 1e-6;

/// A shown region with the pose of its body.
struct ShownRegion {
  SceneEntry entry;
  Region region;
  Pose pose;
};

std::optional<ShownRegion> shown_region(const Panel& panel) {
  const std::optional<ChosenRegion> chosen = chosen_region(panel);
  if (!chosen) return std::nullopt;
  const std::optional<RegionDrag>& drag = panel.state.region_drag;
  const bool drags = drag && !drag->cancelled && drag->entry == chosen->entry;
  return ShownRegion{chosen->entry, drags ? drag->region : chosen->region,
                     pose_of(panel.history.scene().bodies[static_cast<std::size_t>(chosen->scene_body)])};
}

/// Returns the grip under the mouse that is nearest to the eye; empty if there is none.
std::optional<std::size_t> grip_at(const Panel& panel, const ShownRegion& shown, ImVec2 mouse) {
  const ViewCamera camera = view_camera(panel);
  const double reach = 1.5 * kGripSize * ui_scale(panel);
  const std::vector<RegionGrip> grips = region_grips(shown.region);
  std::optional<std::size_t> found;
  double nearest = 0;
  for (std::size_t i = 0; i < grips.size(); ++i) {
    const Vec3 place = shown.pose.to_world(grips[i].place);
    const std::optional<Vec2> pixel = camera.pixel(place);
    const double depth = (place - camera.eye).norm();
    if (!pixel || (*pixel - pixel_of(panel, mouse)).norm() > reach || (found && depth >= nearest)) continue;
    found = i;
    nearest = depth;
  }
  return found;
}

/// Returns the distance that the cursor has moved along the grip's direction since the start [m]; empty if the ray has
/// no solution.
std::optional<double> way_of(const RegionDrag& drag, const Pose& pose, const ViewRay& ray) {
  const RegionGrip grip = region_grips(drag.start)[drag.grip];
  const Vec3 place = pose.to_world(grip.place), direction = pose.rotation * grip.direction;
  const auto from = nearest_on_axis(drag.grabbed, place, direction), to = nearest_on_axis(ray, place, direction);
  return from && to ? std::optional(*to - *from) : std::nullopt;
}

void follow_cursor(Panel& panel, RegionDrag& drag, const Pose& pose) {
  const ViewRay ray = view_camera(panel).ray(pixel_of(panel, ImGui::GetIO().MousePos));
  if (ray.direction == drag.grabbed.direction) return;
  const RegionGrip grip = region_grips(drag.start)[drag.grip];
  const std::optional<double> way = way_of(drag, pose, ray);
  if (!way) return;
  // Round the coordinate of the face, not its displacement.
  const double step = drag_steps(panel, pose.to_world(grip.place)).length, along = grip.place.dot(grip.direction);
  drag.region = drag_grip(drag.start, drag.grip, multiple_of(along + *way, step) - along, kMinRadius);
}

void let_region_go(Panel& panel, const RegionDrag& drag) {
  if (drag.cancelled || drag.region == drag.start) return;
  panel.history.change("Set region of " + full_name(panel.history.scene(), drag.entry),
                       [&](Scene& scene) { set_region(scene, drag.entry, drag.region); });
  panel.history.finish();
}

/// Describes the drag: "x 0.25 m", the face in the body's rest space; "radius 0.1 m"; "+0.5 m", the displacement of a
/// plane.
std::string region_text(const RegionDrag& drag) {
  const RegionGrip grip = region_grips(drag.region)[drag.grip];
  if (const auto* sphere = std::get_if<SphereRegion>(&drag.region))
    return "radius " + format_quantity(sphere->radius, "m");
  if (std::holds_alternative<HalfSpaceRegion>(drag.region)) {
    const double way = (grip.place - region_place(drag.start)).dot(grip.direction);
    return (way < 0 ? "" : "+") + format_quantity(way, "m");
  }
  const auto axis = static_cast<Eigen::Index>(drag.grip / 2);
  return std::string(1, "xyz"[axis]) + " " + format_quantity(grip.place[axis], "m");
}

void draw_grips(Panel& panel, const ShownRegion& shown, std::optional<std::size_t> lit) {
  const float half = kGripSize * ui_scale(panel);
  const std::vector<RegionGrip> grips = region_grips(shown.region);
  ImDrawList* list = ImGui::GetWindowDrawList();
  for (std::size_t i = 0; i < grips.size(); ++i) {
    const std::optional<Vec2> pixel = view_camera(panel).pixel(shown.pose.to_world(grips[i].place));
    if (!pixel) continue;
    const ImVec2 center = on_screen(panel, *pixel);
    const ImVec2 low = {center.x - half, center.y - half}, high = {center.x + half, center.y + half};
    list->AddRectFilled(low, high, lit == i ? kHeldColor : palette::kAccent, 2);
    list->AddRect(low, high, palette::kWindow, 2);
    tag_in_view(panel, "region/" + std::to_string(i), low, high, "");
  }
}

}  // namespace

bool drag_region(Panel& panel) {
  std::optional<RegionDrag>& drag = panel.state.region_drag;
  const std::optional<ShownRegion> shown = shown_region(panel);
  if (!drag && shown && ImGui::IsItemActivated() && ImGui::IsMouseClicked(ImGuiMouseButton_Left)) {
    const ImVec2 mouse = ImGui::GetIO().MouseClickedPos[ImGuiMouseButton_Left];
    if (const std::optional<std::size_t> grip = grip_at(panel, *shown, mouse))
      drag = RegionDrag{.entry = shown->entry,
                        .grip = *grip,
                        .revision = panel.history.revision(),
                        .start = shown->region,
                        .region = shown->region,
                        .grabbed = view_camera(panel).ray(pixel_of(panel, mouse))};
  }
  if (!drag) return false;
  const std::optional<SceneEntry> now = shown ? std::optional(shown->entry) : std::nullopt;
  if (gesture_lost(panel, now, drag->entry, drag->revision)) drag->cancelled = true;
  if (!drag->cancelled) follow_cursor(panel, *drag, shown->pose);
  if (ImGui::IsMouseDown(ImGuiMouseButton_Left)) return true;
  let_region_go(panel, *drag);
  drag.reset();
  return true;
}

void draw_region(Panel& panel) {
  const std::optional<ShownRegion> shown = shown_region(panel);
  if (!shown) return;
  const std::optional<RegionDrag>& drag = panel.state.region_drag;
  const bool dragging = drag && !drag->cancelled;
  ImDrawList* list = ImGui::GetWindowDrawList();
  draw_world_lines(panel, list, region_lines(shown->region, region_size(panel)), shown->pose,
                   dragging ? kHeldColor : palette::kAccent);
  const bool free = is_active_view(panel) && ImGui::IsWindowHovered() && !ImGui::IsMouseDown(ImGuiMouseButton_Left);
  draw_grips(panel, *shown,
             dragging ? std::optional(drag->grip)
             : free   ? grip_at(panel, *shown, ImGui::GetIO().MousePos)
                      : std::nullopt);
  if (dragging) draw_readout(panel, list, region_text(*drag));
}

}  // namespace griffith::ui
