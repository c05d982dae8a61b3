#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "sim/core/number_text.h"
#include "sim/scene/body_pose.h"
#include "sim/scene/shape_fields.h"
#include "ui/model/entry_choice.h"
#include "ui/model/entry_place.h"
#include "ui/model/gizmo_scale.h"
#include "ui/model/region_outline.h"
#include "ui/panels/chosen_region.h"
#include "ui/panels/overlays.h"
#include "ui/panels/view_drawing.h"
#include "ui/widgets/field_range.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace griffith::ui {
namespace {

constexpr float kArrowLength = 96, kReach = 7;  // design pixels
constexpr std::array<ImU32, 3> kAxisColors = {IM_COL32(240, 84, 84, 255), IM_COL32(120, 200, 90, 255),
                                              IM_COL32(84, 150, 250, 255)};

/// Returns the entry with the gizmo, if an edit of its placement takes effect at once; else empty.
std::optional<SceneEntry> target_of(const Panel& panel) {
  if (panel.state.gizmo == GizmoTool::none || panel.input.frame.step != 0) return std::nullopt;
  const Scene& scene = panel.history.scene();
  const std::optional<SceneEntry> entry = active_entry(panel.state, scene);
  return entry && placement_of(scene, *entry) ? entry : std::nullopt;
}

double arrow_length(const Panel& panel) { return kArrowLength * ui_scale(panel); }

std::vector<HandleShape> shapes_of(const Panel& panel, const SceneEntry& entry) {
  const Scene& scene = panel.history.scene();
  const std::optional<GizmoDrag>& drag = panel.state.gizmo_drag;
  const Placement now = drag && !drag->cancelled ? drag->placement : *placement_of(scene, entry);
  const ViewCamera camera = view_camera(panel);
  if (panel.state.gizmo == GizmoTool::scale) {
    if (!scale_problem(scene, entry).empty()) return {};
    return scale_shapes(camera, now.position, arrow_length(panel), scale_frame(scene, entry));
  }
  std::vector<HandleShape> shapes = handle_shapes(camera, now.position, arrow_length(panel));
  if (!can_turn(entry))
    std::erase_if(shapes, [](const HandleShape& shape) { return shape.handle.kind == GizmoHandle::Kind::ring; });
  return shapes;
}

/// Returns the bounding box of a body in its rest space; empty for another entry.
Eigen::AlignedBox3d rest_box(const Panel& panel, const SceneEntry& entry) {
  Eigen::AlignedBox3d box;
  if (entry.kind != EntryKind::body) return box;
  const Frame& frame = panel.input.frame;
  const Pose pose = pose_of(panel.history.scene().bodies[static_cast<std::size_t>(entry.index)]);
  for (std::size_t tet = 0; tet < frame.elements.tets.size(); ++tet) {
    if (frame.bodies[frame.elements.bodies[TetId(tet)]].scene_body != entry.index) continue;
    for (const NodeId node : frame.elements.tets[TetId(tet)])
      box.extend(pose.to_local(frame.nodes.rest_positions[node]));
  }
  return box;
}

void keep_in_range(Vec3& position) {
  const Numbers range = range_of<BodyDescription>("position");
  position = position.cwiseMax(range.minimum).cwiseMin(range.maximum);
}

/// Returns the entries that move with the dragged one: all selected ones except parts of a selected body.
std::vector<SceneEntry> moved_with(const Panel& panel, const SceneEntry& entry) {
  const Scene& scene = panel.history.scene();
  std::vector<SceneEntry> moved = selected_entries(panel.state, scene);
  const std::vector<SceneEntry> chosen = moved;
  std::erase_if(moved, [&](const SceneEntry& other) {
    const std::optional<int> body = body_of(scene, other);
    const bool carried =
        body && other.kind != EntryKind::body && std::ranges::count(chosen, SceneEntry{EntryKind::body, *body}) > 0;
    return other == entry || carried || !placement_of(scene, other);
  });
  return moved;
}

void grab(Panel& panel, const SceneEntry& entry, GizmoHandle handle, const ViewRay& ray) {
  const Scene& scene = panel.history.scene();
  const Placement start = *placement_of(scene, entry);
  panel.state.gizmo_drag = GizmoDrag{.handle = handle,
                                     .entry = entry,
                                     .revision = panel.history.revision(),
                                     .start = start,
                                     .placement = start,
                                     .grabbed = ray,
                                     .last = ray,
                                     .radius = ring_radius(view_camera(panel), start.position, arrow_length(panel)),
                                     .box = rest_box(panel, entry)};
  if (scales(handle)) {
    panel.state.gizmo_drag->scaling.frame = scale_frame(scene, entry);
  } else if (handle.kind != GizmoHandle::Kind::ring) {
    panel.state.gizmo_drag->surfaces = snap_scene(scene, panel.input.frame, entry, moved_with(panel, entry));
  }
}

/// Moves the other entries of a move by its displacement.
void move_others(Scene& scene, const GizmoDrag& drag, const std::vector<SceneEntry>& others) {
  for (const SceneEntry& other : others) {
    Placement from = *placement_of(scene, other), to = from;
    to.position += drag.placement.position - drag.start.position;
    keep_in_range(to.position);
    move_entry(scene, other, from, to);
  }
}

/// Scales the other entries of a scaling along all axes, and their distances from the dragged one.
void scale_others(Scene& scene, const GizmoDrag& drag, const std::vector<SceneEntry>& others) {
  const double factor = drag.scaling.factors.x();
  for (const SceneEntry& other : others) {
    Placement from = *placement_of(scene, other), to = from;
    to.position = moved_place(drag.start.position, factor * (from.position - drag.start.position));
    if (scale_problem(scene, other).empty()) scale_entry(scene, other, drag.scaling.factors);
    move_entry(scene, other, from, to);
  }
}

/// Returns the entries besides the active one on which the handle acts.
std::vector<SceneEntry> others_of(const Panel& panel, const GizmoDrag& drag) {
  const bool alone = drag.handle.kind == GizmoHandle::Kind::ring || drag.handle.kind == GizmoHandle::Kind::stretch;
  return alone ? std::vector<SceneEntry>() : moved_with(panel, drag.entry);
}

std::string label_of(const Panel& panel, const GizmoDrag& drag, std::size_t others) {
  const std::string action = scales(drag.handle)                           ? "Scale "
                             : drag.handle.kind == GizmoHandle::Kind::ring ? "Rotate "
                                                                           : "Move ";
  const std::string more = others == 0 ? "" : " and " + std::to_string(others) + " more";
  return action + full_name(panel.history.scene(), drag.entry) + more;
}

/// Ends the drag. Makes one entry of the history if anything changed.
void let_go(Panel& panel, const GizmoDrag& drag) {
  if (drag.cancelled || !has_effect(drag)) return;
  const std::vector<SceneEntry> others = others_of(panel, drag);
  panel.history.change(label_of(panel, drag, others.size()), [&](Scene& scene) {
    if (scales(drag.handle)) {
      scale_others(scene, drag, others);
      scale_entry(scene, drag.entry, drag.scaling.factors);
    } else {
      move_others(scene, drag, others);
      move_entry(scene, drag.entry, drag.start, drag.placement);
    }
  });
  panel.history.finish();
}

void continue_drag(Panel& panel, GizmoDrag& drag) {
  if (gesture_lost(panel, target_of(panel), drag.entry, drag.revision)) drag.cancelled = true;
  if (!drag.cancelled) {
    follow_ray(drag, view_camera(panel).ray(pixel_of(panel, ImGui::GetIO().MousePos)),
               drag_steps(panel, drag.start.position));
    keep_in_range(drag.placement.position);
  }
  if (ImGui::IsMouseDown(ImGuiMouseButton_Left)) return;
  let_go(panel, drag);
  panel.state.gizmo_drag.reset();
}

/// Returns the handle under the mouse.
const HandleShape* pointed_at(const Panel& panel, const std::vector<HandleShape>& shapes, ImVec2 mouse) {
  return shape_at(shapes, pixel_of(panel, mouse), kReach * ui_scale(panel));
}

std::optional<GizmoHandle> lit_handle(const Panel& panel, const std::vector<HandleShape>& shapes) {
  const std::optional<GizmoDrag>& drag = panel.state.gizmo_drag;
  if (drag) return drag->cancelled ? std::nullopt : std::optional(drag->handle);
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  const bool free = is_active_view(panel) && ImGui::IsWindowHovered() && !ImGui::IsMouseDown(ImGuiMouseButton_Left);
  const HandleShape* shape = free ? pointed_at(panel, shapes, mouse) : nullptr;
  return shape ? std::optional(shape->handle) : std::nullopt;
}

void draw_arrow(ImDrawList* list, const std::vector<ImVec2>& line, ImU32 color, float width) {
  const ImVec2 tail = line.front(), tip = line.back();
  list->AddLine(tail, tip, color, width);
  const float x = tip.x - tail.x, y = tip.y - tail.y, length = std::max(std::hypot(x, y), 1.0f);
  const ImVec2 along = {x / length * 5 * width, y / length * 5 * width}, side = {along.y * 0.45f, -along.x * 0.45f};
  list->AddTriangleFilled({tip.x + along.x / 2, tip.y + along.y / 2},
                          {tip.x - along.x / 2 + side.x, tip.y - along.y / 2 + side.y},
                          {tip.x - along.x / 2 - side.x, tip.y - along.y / 2 - side.y}, color);
}

/// Draws a line with a square at its end.
void draw_stretch(ImDrawList* list, const std::vector<ImVec2>& line, ImU32 color, float width) {
  const ImVec2 tip = line.back();
  const float half = 2.2f * width;
  list->AddLine(line.front(), tip, color, width);
  list->AddRectFilled({tip.x - half, tip.y - half}, {tip.x + half, tip.y + half}, color);
}

ImU32 color_of(GizmoHandle handle) {
  const bool of_all = handle.kind == GizmoHandle::Kind::free || handle.kind == GizmoHandle::Kind::size;
  return of_all ? palette::kText : kAxisColors[static_cast<std::size_t>(handle.axis)];
}

void draw_shape(const Panel& panel, ImDrawList* list, const HandleShape& shape, bool lit) {
  const ImU32 color = lit ? kHeldColor : color_of(shape.handle);
  const float width = (lit ? 4.0f : 2.5f) * ui_scale(panel);
  std::vector<ImVec2> line;
  for (const Vec2& pixel : shape.outline) line.push_back(on_screen(panel, pixel));
  const int count = static_cast<int>(line.size());
  list->AddPolyline(line.data(), count, kRimColor, ImDrawFlags_None, width + 2.5f * ui_scale(panel));
  if (shape.handle.kind == GizmoHandle::Kind::arrow) return draw_arrow(list, line, color, width);
  if (shape.handle.kind == GizmoHandle::Kind::stretch) return draw_stretch(list, line, color, width);
  if (shape.handle.kind == GizmoHandle::Kind::plane) {
    constexpr ImU32 kAlpha = 110;
    const ImU32 filling = (color & ~IM_COL32_A_MASK) | (kAlpha << IM_COL32_A_SHIFT);
    list->AddConvexPolyFilled(line.data(), count - 1, filling);
  }
  list->AddPolyline(line.data(), count, color, ImDrawFlags_None, width);
}

void tag_shape(Panel& panel, const HandleShape& shape, std::string text) {
  const ImVec2 grip = on_screen(panel, shape.grip);
  const float half = kReach * ui_scale(panel);
  tag_in_view(panel, "gizmo/" + handle_name(shape.handle), {grip.x - half, grip.y - half},
              {grip.x + half, grip.y + half}, std::move(text));
}

/// Draws the dragged box or region as it would be released.
void draw_outline(const Panel& panel, ImDrawList* list, const GizmoDrag& drag) {
  const Vec3& factors = drag.scaling.factors;
  if (!drag.box.isEmpty()) {
    const Pose pose{drag.placement.position, rotation_of(drag.placement.rotation_degrees)};
    const BoxRegion box{drag.box.min().cwiseProduct(factors), drag.box.max().cwiseProduct(factors)};
    return draw_world_lines(panel, list, region_lines(box, 0), pose, kHeldColor);
  }
  const Scene& scene = panel.history.scene();
  if (!region_of(scene, drag.entry)) return;
  Region region = *region_of(scene, drag.entry);
  scale_about_place(region, factors);
  Pose pose = pose_of(scene.bodies[static_cast<std::size_t>(*body_of(scene, drag.entry))]);
  pose.translation += drag.placement.position - drag.start.position;
  draw_world_lines(panel, list, region_lines(region, region_size(panel)), pose, kHeldColor);
}

/// Draws a ring on the surface that the drag has snapped to.
void draw_snap(const Panel& panel, ImDrawList* list, const Snap& snap) {
  constexpr double kRadius = 10;  // design pixels
  const double radius = kRadius * ui_scale(panel) * view_camera(panel).pixel_length(snap.point);
  const Pose pose{snap.point, Quat::FromTwoVectors(Vec3::UnitZ(), snap.normal)};
  std::vector<RegionLine> lines = circle_lines(Vec3::Zero(), radius * Vec3::UnitX(), radius * Vec3::UnitY());
  lines.push_back({Vec3::Zero(), 2 * radius * Vec3::UnitZ()});
  draw_world_lines(panel, list, lines, pose, palette::kAccent);
}

/// Returns the drag's text, with the number of elements of a scaled body.
std::string text_of(const Panel& panel, const GizmoDrag& drag) {
  if (!scales(drag.handle) || drag.entry.kind != EntryKind::body) return drag_text(drag);
  Shape shape = panel.history.scene().bodies[static_cast<std::size_t>(drag.entry.index)].shape;
  scale_lengths(shape, drag.scaling.factors);
  const double tets = tet_count(shape);
  return drag_text(drag) + (tets > 0 ? "   about " + count_text(std::llround(tets)) + " tetrahedra" : "");
}

}  // namespace

bool drag_gizmo(Panel& panel) {
  std::optional<GizmoDrag>& drag = panel.state.gizmo_drag;
  const std::optional<SceneEntry> entry = target_of(panel);
  if (!drag && entry && ImGui::IsItemActivated() && ImGui::IsMouseClicked(ImGuiMouseButton_Left)) {
    const ImVec2 mouse = ImGui::GetIO().MouseClickedPos[ImGuiMouseButton_Left];
    const std::vector<HandleShape> shapes = shapes_of(panel, *entry);
    if (const HandleShape* shape = pointed_at(panel, shapes, mouse))
      grab(panel, *entry, shape->handle, view_camera(panel).ray(pixel_of(panel, mouse)));
  }
  if (!drag) return false;
  continue_drag(panel, *drag);
  return true;
}

void draw_gizmo(Panel& panel) {
  const std::optional<SceneEntry> entry = target_of(panel);
  if (!entry) return;
  const std::optional<GizmoDrag>& drag = panel.state.gizmo_drag;
  const bool dragging = drag && !drag->cancelled;
  const std::vector<HandleShape> shapes = shapes_of(panel, *entry);
  const std::optional<GizmoHandle> lit = lit_handle(panel, shapes);
  ImDrawList* list = ImGui::GetWindowDrawList();
  if (dragging) draw_outline(panel, list, *drag);
  for (auto shape = shapes.rbegin(); shape != shapes.rend(); ++shape) {
    draw_shape(panel, list, *shape, lit == shape->handle);
    tag_shape(panel, *shape, dragging && lit == shape->handle ? text_of(panel, *drag) : "");
  }
  if (dragging && drag->snap) draw_snap(panel, list, *drag->snap);
  if (dragging) draw_readout(panel, list, text_of(panel, *drag));
}

}  // namespace griffith::ui
