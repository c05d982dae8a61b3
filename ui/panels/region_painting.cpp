#include <cmath>
#include <string>
#include <utility>

#include "ui/model/entry_place.h"
#include "ui/model/painted_region.h"
#include "ui/panels/chosen_region.h"
#include "ui/panels/overlays.h"
#include "ui/panels/view_drawing.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace griffith::ui {
namespace {

constexpr float kBrushRadius = 24;  // design pixels

/// Applies the brush at a point of the picture. True if the body is there.
bool put_down(const Panel& panel, const ChosenRegion& canvas, RegionStroke& stroke, const Vec2& pixel) {
  const Frame& frame = panel.input.frame;
  const ViewCamera camera = view_camera(panel);
  const ViewRay ray = camera.ray(pixel);
  stroke.last = pixel;
  const std::optional<Vec3> place = place_on_body(frame, canvas.scene_body, ray);
  if (!place) return false;
  const double radius = kBrushRadius * ui_scale(panel) * camera.pixel_length(*place);
  for (const int node : nodes_under_brush(frame, canvas.scene_body, *place, ray.direction, radius)) {
    if (stroke.erases) {
      stroke.nodes.erase(node);
    } else {
      stroke.nodes.insert(node);
    }
  }
  return true;
}

/// Begins a stroke if the button went down on the body.
void begin_stroke(Panel& panel, const ChosenRegion& canvas) {
  RegionStroke stroke{
      .entry = canvas.entry,
      .revision = panel.history.revision(),
      .erases = ImGui::GetIO().KeyCtrl,
      .nodes = nodes_in_region(panel.input.frame, panel.history.scene(), canvas.scene_body, canvas.region)};
  const ImVec2 clicked = ImGui::GetIO().MouseClickedPos[ImGuiMouseButton_Left];
  if (put_down(panel, canvas, stroke, pixel_of(panel, clicked))) panel.state.region_stroke = std::move(stroke);
}

/// Applies the brush along the path of the mouse, without gaps.
void follow_mouse(const Panel& panel, const ChosenRegion& canvas, RegionStroke& stroke) {
  const Vec2 from = stroke.last, to = pixel_of(panel, ImGui::GetIO().MousePos);
  const int places = static_cast<int>(std::ceil((to - from).norm() / (kBrushRadius * ui_scale(panel))));
  for (int i = 1; i <= places; ++i) put_down(panel, canvas, stroke, from + (to - from) * i / places);
}

void end_stroke(Panel& panel, const RegionStroke& stroke) {
  if (stroke.cancelled) return;
  const NodeListRegion region{{stroke.nodes.begin(), stroke.nodes.end()}};
  panel.history.change("Paint region of " + full_name(panel.history.scene(), stroke.entry),
                       [&](Scene& scene) { set_region(scene, stroke.entry, region); });
  panel.history.finish();
}

void draw_node(const Panel& panel, ImDrawList* list, const Vec3& place) {
  const std::optional<Vec2> pixel = view_camera(panel).pixel(place);
  if (!pixel) return;
  const float radius = 3.5f * ui_scale(panel);
  list->AddCircleFilled(on_screen(panel, *pixel), radius + 1.5f, kRimColor);
  list->AddCircleFilled(on_screen(panel, *pixel), radius, palette::kAccent);
}

}  // namespace

bool paint_region(Panel& panel) {
  std::optional<RegionStroke>& stroke = panel.state.region_stroke;
  const std::optional<ChosenRegion> canvas = chosen_region(panel);
  if (!stroke && panel.state.paint_regions && canvas && ImGui::IsItemActivated() &&
      ImGui::IsMouseClicked(ImGuiMouseButton_Left))
    begin_stroke(panel, *canvas);
  if (!stroke) return false;
  const std::optional<SceneEntry> now = canvas ? std::optional(canvas->entry) : std::nullopt;
  if (gesture_lost(panel, now, stroke->entry, stroke->revision)) stroke->cancelled = true;
  if (!stroke->cancelled) follow_mouse(panel, *canvas, *stroke);
  if (ImGui::IsMouseDown(ImGuiMouseButton_Left)) return true;
  end_stroke(panel, *stroke);
  stroke.reset();
  return true;
}

void draw_painted_region(Panel& panel) {
  const std::optional<ChosenRegion> canvas = chosen_region(panel);
  if (!canvas) return;
  const std::optional<RegionStroke>& stroke = panel.state.region_stroke;
  const auto* list = std::get_if<NodeListRegion>(&canvas->region);
  std::set<int> nodes;
  if (stroke && !stroke->cancelled) {
    nodes = stroke->nodes;
  } else if (list) {
    nodes.insert(list->nodes.begin(), list->nodes.end());
  }
  ImDrawList* drawing = ImGui::GetWindowDrawList();
  for (const Vec3& place : places_of_nodes(panel.input.frame, canvas->scene_body, nodes))
    draw_node(panel, drawing, place);
  if (!panel.state.paint_regions || !ImGui::IsWindowHovered()) return;
  drawing->AddCircle(ImGui::GetIO().MousePos, kBrushRadius * ui_scale(panel), kHeldColor, 0, 1.5f * ui_scale(panel));
  draw_readout(panel, drawing, std::to_string(nodes.size()) + (nodes.size() == 1 ? " node" : " nodes"));
}

}  // namespace griffith::ui
