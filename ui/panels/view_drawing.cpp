#include "ui/panels/view_drawing.h"

#include <algorithm>
#include <utility>

#include "ui/model/gizmo_geometry.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace griffith::ui {

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
  const float scale = ui_scale(panel), pad = 8 * scale;
  const ImVec2 extent = ImGui::CalcTextSize(text.c_str());
  const ImVec2 minimum = panel.state.viewport_minimum, size = panel.state.viewport_size;
  const auto within = [pad](float preferred, float low, float room, float need) {
    return std::max(low + pad, std::min(preferred, low + room - need - 2 * pad));
  };
  const ImVec2 low = {within(place.x + 18 * scale, minimum.x, size.x, extent.x),
                      within(place.y + 18 * scale, minimum.y, size.y, extent.y)};
  list->AddRectFilled({low.x - pad, low.y - pad / 2}, {low.x + extent.x + pad, low.y + extent.y + pad / 2},
                      IM_COL32(24, 27, 32, 220), 5 * scale);
  list->AddText(low, palette::kText, text.c_str());
}

}  // namespace griffith::ui
