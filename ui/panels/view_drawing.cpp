#include "ui/panels/view_drawing.h"

#include <algorithm>
#include <utility>

#include "ui/model/gizmo_geometry.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace griffith::ui {

ScreenArea view_area(const Panel& panel) {
  const ImVec2 corner = panel.state.viewport_minimum;
  const auto [low, size] = area_of(panel.state.four_views, panel.view, panel.state.viewport_size);
  return {{corner.x + low.x, corner.y + low.y}, {corner.x + low.x + size.x, corner.y + low.y + size.y}};
}

bool is_active_view(const Panel& panel) { return panel.view == panel.state.four_views.active; }

ViewCamera view_camera(const Panel& panel) {
  ViewCamera camera = panel.input.views[static_cast<std::size_t>(panel.view)].camera;
  const ImVec2 size = area_of(panel.state.four_views, panel.view, panel.state.viewport_size).size;
  camera.width = size.x;
  camera.height = size.y;
  return camera;
}

Vec2 pixel_of(const Panel& panel, ImVec2 mouse) {
  const ImVec2 low = view_area(panel).minimum;
  return {mouse.x - low.x, mouse.y - low.y};
}

ImVec2 on_screen(const Panel& panel, const Vec2& pixel) {
  const ImVec2 low = view_area(panel).minimum;
  return {low.x + static_cast<float>(pixel.x()), low.y + static_cast<float>(pixel.y())};
}

DragSteps drag_steps(const Panel& panel, const Vec3& place) {
  constexpr double kStepsAcross = 40, kFinest = 1e-9, kReach = 14;  // kReach: design pixels
  const double pixel = std::max(view_camera(panel).pixel_length(place), kFinest);
  DragSteps steps{.length = round_step(pixel)};
  if (panel.state.snap == ImGui::GetIO().KeyCtrl) return steps;
  steps.angle = 15;
  steps.factor = 0.1;
  if (panel.state.snap_target == SnapTarget::surfaces) {
    steps.reach = kReach * ui_scale(panel) * pixel;
  } else {
    steps.length = round_step(std::max((panel.input.high - panel.input.low).norm() / kStepsAcross, pixel));
  }
  return steps;
}

double region_size(const Panel& panel) { return std::max(0.6 * (panel.input.high - panel.input.low).norm(), 1e-3); }

void draw_world_lines(const Panel& panel, ImDrawList* list, const std::vector<RegionLine>& lines, const Pose& pose,
                      ImU32 color) {
  const ViewCamera camera = view_camera(panel);
  const float width = 1.5f * ui_scale(panel);
  for (const auto& [shade, line_width] : {std::pair(kRimColor, 2.5f * width), std::pair(color, width)}) {
    for (const auto& [start, end] : lines) {
      const std::optional<Vec2> a = camera.pixel(pose.to_world(start)), b = camera.pixel(pose.to_world(end));
      if (a && b) list->AddLine(on_screen(panel, *a), on_screen(panel, *b), shade, line_width);
    }
  }
}

void draw_readout(const Panel& panel, ImDrawList* list, const std::string& text, ImVec2 place) {
  if (!is_active_view(panel)) return;
  const float scale = ui_scale(panel), pad = 8 * scale;
  const ImVec2 extent = ImGui::CalcTextSize(text.c_str());
  const auto [minimum, end] = view_area(panel);
  const ImVec2 size = {end.x - minimum.x, end.y - minimum.y};
  const auto within = [pad](float preferred, float low, float room, float need) {
    return std::max(low + pad, std::min(preferred, low + room - need - 2 * pad));
  };
  const ImVec2 low = {within(place.x + 18 * scale, minimum.x, size.x, extent.x),
                      within(place.y + 18 * scale, minimum.y, size.y, extent.y)};
  list->AddRectFilled({low.x - pad, low.y - pad / 2}, {low.x + extent.x + pad, low.y + extent.y + pad / 2},
                      IM_COL32(24, 27, 32, 220), 5 * scale);
  list->AddText(low, palette::kText, text.c_str());
}

void tag_in_view(const Panel& panel, std::string tag, ImVec2 low, ImVec2 high, std::string text) {
  if (is_active_view(panel)) panel.tags.push_back({std::move(tag), low, high, std::move(text)});
}

}  // namespace griffith::ui
