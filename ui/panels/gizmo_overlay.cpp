#include "ui/panels/gizmo_overlay.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "sim/scene/body_pose.h"
#include "ui/model/gizmo_geometry.h"
#include "ui/widgets/field_range.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace griffith::ui {
namespace {

constexpr float kArrowLength = 96, kReach = 7;  // design pixels
constexpr std::array<ImU32, 3> kAxisColors = {IM_COL32(240, 84, 84, 255), IM_COL32(120, 200, 90, 255),
                                              IM_COL32(84, 150, 250, 255)};
constexpr ImU32 kHeldColor = IM_COL32(255, 214, 92, 255);

bool shows(const Panel& panel) {
  const auto body = static_cast<std::size_t>(panel.state.selected_body);
  return panel.state.show_gizmo && panel.input.frame.step == 0 && body < panel.history.scene().bodies.size();
}

const BodyDescription& chosen_body(const Panel& panel) {
  return panel.history.scene().bodies[static_cast<std::size_t>(panel.state.selected_body)];
}

/// As large as the picture is drawn now.
ViewCamera view_camera(const Panel& panel) {
  ViewCamera camera = panel.input.camera;
  camera.width = panel.state.viewport_size.x;
  camera.height = panel.state.viewport_size.y;
  return camera;
}

Vec2 pixel_of(const Panel& panel, ImVec2 mouse) {
  return {mouse.x - panel.state.viewport_minimum.x, mouse.y - panel.state.viewport_minimum.y};
}

ImVec2 on_screen(const Panel& panel, const Vec2& pixel) {
  return {panel.state.viewport_minimum.x + static_cast<float>(pixel.x()),
          panel.state.viewport_minimum.y + static_cast<float>(pixel.y())};
}

double arrow_length(const Panel& panel) { return kArrowLength * ui_scale(panel); }

std::vector<HandleShape> shapes_of(const Panel& panel) {
  const std::optional<GizmoDrag>& drag = panel.state.gizmo_drag;
  const Vec3& place = drag && !drag->cancelled ? drag->placement.position : chosen_body(panel).position;
  return handle_shapes(view_camera(panel), place, arrow_length(panel));
}

/// Round what the frame has of the body, in the body's rest space.
Eigen::AlignedBox3d rest_box(const Panel& panel) {
  const Frame& frame = panel.input.frame;
  const Pose pose = pose_of(chosen_body(panel));
  Eigen::AlignedBox3d box;
  for (std::size_t tet = 0; tet < frame.elements.tets.size(); ++tet) {
    if (frame.bodies[frame.elements.bodies[TetId(tet)]].scene_body != panel.state.selected_body) continue;
    for (const NodeId node : frame.elements.tets[TetId(tet)]) box.extend(pose.to_local(frame.nodes.positions[node]));
  }
  return box;
}

void grab(Panel& panel, GizmoHandle handle, const ViewRay& ray) {
  const BodyDescription& body = chosen_body(panel);
  const Placement start{body.position, body.rotation_degrees};
  panel.state.gizmo_drag = GizmoDrag{.handle = handle,
                                     .body = panel.state.selected_body,
                                     .revision = panel.history.revision(),
                                     .start = start,
                                     .placement = start,
                                     .grabbed = ray,
                                     .last = ray,
                                     .radius = ring_radius(view_camera(panel), start.position, arrow_length(panel)),
                                     .box = rest_box(panel)};
}

/// Round steps that suit the size of all bodies with Ctrl; else as fine as pixels.
DragSteps drag_steps(const Panel& panel, const Vec3& place) {
  constexpr double kStepsAcross = 40, kFinest = 1e-9, kSnappedTurn = 15, kFineTurn = 0.1;
  const double pixel = std::max(view_camera(panel).pixel_length(place), kFinest);
  if (!ImGui::GetIO().KeyCtrl) return {round_step(pixel), kFineTurn};
  return {round_step(std::max((panel.input.high - panel.input.low).norm() / kStepsAcross, pixel)), kSnappedTurn};
}

void keep_in_range(Vec3& position) {
  const Numbers range = range_of<BodyDescription>("position");
  position = position.cwiseMax(range.minimum).cwiseMin(range.maximum);
}

/// One entry of the history, if the body moved.
void let_go(Panel& panel, const GizmoDrag& drag) {
  if (drag.cancelled || drag.placement == drag.start) return;
  const std::string verb = drag.handle.kind == GizmoHandle::Kind::ring ? "Turn " : "Move ";
  panel.history.change(verb + chosen_body(panel).name, [&](Scene& scene) {
    BodyDescription& body = scene.bodies[static_cast<std::size_t>(drag.body)];
    body.position = drag.placement.position;
    body.rotation_degrees = drag.placement.rotation_degrees;
  });
  panel.history.finish();
}

void go_on(Panel& panel, GizmoDrag& drag) {
  const bool lost = !shows(panel) || panel.history.revision() != drag.revision ||
                    panel.state.selected_body != drag.body || ImGui::IsKeyPressed(key::kEscape, false);
  if (lost) drag.cancelled = true;
  if (!drag.cancelled) {
    follow_ray(drag, view_camera(panel).ray(pixel_of(panel, ImGui::GetIO().MousePos)),
               drag_steps(panel, drag.start.position));
    keep_in_range(drag.placement.position);
  }
  if (ImGui::IsMouseDown(ImGuiMouseButton_Left)) return;
  let_go(panel, drag);
  panel.state.gizmo_drag.reset();
}

/// What the mouse points at.
const HandleShape* pointed_at(const Panel& panel, const std::vector<HandleShape>& shapes, ImVec2 mouse) {
  return shape_at(shapes, pixel_of(panel, mouse), kReach * ui_scale(panel));
}

std::optional<GizmoHandle> lit_handle(const Panel& panel, const std::vector<HandleShape>& shapes) {
  const std::optional<GizmoDrag>& drag = panel.state.gizmo_drag;
  if (drag) return drag->cancelled ? std::nullopt : std::optional(drag->handle);
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  const bool free = ImGui::IsWindowHovered() && !ImGui::IsMouseDown(ImGuiMouseButton_Left);
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

void draw_shape(const Panel& panel, ImDrawList* list, const HandleShape& shape, bool lit) {
  const ImU32 color = lit ? kHeldColor : kAxisColors[static_cast<std::size_t>(shape.handle.axis)];
  const float width = (lit ? 4.0f : 2.5f) * ui_scale(panel);
  std::vector<ImVec2> line;
  for (const Vec2& pixel : shape.outline) line.push_back(on_screen(panel, pixel));
  const int count = static_cast<int>(line.size());
  if (shape.handle.kind == GizmoHandle::Kind::arrow) return draw_arrow(list, line, color, width);
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
  panel.tags.push_back({"gizmo/" + handle_name(shape.handle),
                        {grip.x - half, grip.y - half},
                        {grip.x + half, grip.y + half},
                        std::move(text)});
}

/// The box round the body where it would be if let go now.
void draw_outline(const Panel& panel, ImDrawList* list, const GizmoDrag& drag) {
  if (drag.box.isEmpty()) return;
  const ViewCamera camera = view_camera(panel);
  const Pose pose{drag.placement.position, rotation_of(drag.placement.rotation_degrees)};
  const auto corner = [&](int i) {
    return camera.pixel(pose.to_world(drag.box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(i))));
  };
  for (int i = 0; i < 8; ++i)
    for (const int bit : {1, 2, 4}) {
      const std::optional<Vec2> a = corner(i), b = corner(i | bit);
      if (!(i & bit) && a && b)
        list->AddLine(on_screen(panel, *a), on_screen(panel, *b), kHeldColor, 1.5f * ui_scale(panel));
    }
}

/// What the drag comes to, beside the cursor, within the picture.
void draw_readout(const Panel& panel, ImDrawList* list, const std::string& text) {
  const float scale = ui_scale(panel), pad = 8 * scale;
  const ImVec2 extent = ImGui::CalcTextSize(text.c_str()), mouse = ImGui::GetIO().MousePos;
  const ImVec2 minimum = panel.state.viewport_minimum, size = panel.state.viewport_size;
  const auto within = [pad](float wanted, float low, float room, float need) {
    return std::max(low + pad, std::min(wanted, low + room - need - 2 * pad));
  };
  const ImVec2 low = {within(mouse.x + 18 * scale, minimum.x, size.x, extent.x),
                      within(mouse.y + 18 * scale, minimum.y, size.y, extent.y)};
  list->AddRectFilled({low.x - pad, low.y - pad / 2}, {low.x + extent.x + pad, low.y + extent.y + pad / 2},
                      IM_COL32(24, 27, 32, 220), 5 * scale);
  list->AddText(low, palette::kText, text.c_str());
}

}  // namespace

bool drag_gizmo(Panel& panel) {
  std::optional<GizmoDrag>& drag = panel.state.gizmo_drag;
  if (!drag && shows(panel) && ImGui::IsItemActivated() && ImGui::IsMouseClicked(ImGuiMouseButton_Left)) {
    const ImVec2 mouse = ImGui::GetIO().MouseClickedPos[ImGuiMouseButton_Left];
    const std::vector<HandleShape> shapes = shapes_of(panel);
    if (const HandleShape* shape = pointed_at(panel, shapes, mouse))
      grab(panel, shape->handle, view_camera(panel).ray(pixel_of(panel, mouse)));
  }
  if (!drag) return false;
  go_on(panel, *drag);
  return true;
}

void draw_gizmo(Panel& panel) {
  if (!shows(panel)) return;
  const std::optional<GizmoDrag>& drag = panel.state.gizmo_drag;
  const bool dragging = drag && !drag->cancelled;
  const std::vector<HandleShape> shapes = shapes_of(panel);
  const std::optional<GizmoHandle> lit = lit_handle(panel, shapes);
  ImDrawList* list = ImGui::GetWindowDrawList();
  if (dragging) draw_outline(panel, list, *drag);
  for (auto shape = shapes.rbegin(); shape != shapes.rend(); ++shape) {
    draw_shape(panel, list, *shape, lit == shape->handle);
    tag_shape(panel, *shape, dragging && lit == shape->handle ? drag_text(*drag) : "");
  }
  if (dragging) draw_readout(panel, list, drag_text(*drag));
}

}  // namespace griffith::ui
