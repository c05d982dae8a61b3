#include <algorithm>

#include "ui/model/units.h"
#include "ui/panels/overlays.h"
#include "ui/panels/view_drawing.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace griffith::ui {
namespace {

double length_of(const std::vector<Vec3>& way) {
  double length = 0;
  for (std::size_t i = 1; i < way.size(); ++i) length += (way[i] - way[i - 1]).norm();
  return length;
}

/// Draws a ring as large as the projectile, at least a few pixels.
void draw_impact(const Panel& panel, ImDrawList* list, const Vec3& place) {
  const ViewCamera camera = view_camera(panel);
  const std::optional<Vec2> pixel = camera.pixel(place);
  if (!pixel) return;
  const float scale = ui_scale(panel);
  const float radius = static_cast<float>(panel.state.shot.radius / std::max(camera.pixel_length(place), 1e-9));
  const ImVec2 center = on_screen(panel, *pixel);
  list->AddCircle(center, std::max(radius, 4 * scale), kRimColor, 0, 4 * scale);
  list->AddCircle(center, std::max(radius, 4 * scale), kHeldColor, 0, 2 * scale);
  list->AddCircleFilled(center, 2 * scale, kHeldColor);
}

}  // namespace

void aim_shot(Panel& panel, const Vec2& cursor) {
  std::optional<Vec2>& aimed_at = panel.state.aimed_at;
  if (ImGui::IsItemHovered() && ImGui::IsMouseClicked(ImGuiMouseButton_Right)) aimed_at = cursor;
  if (!aimed_at) return;
  aimed_at = cursor;
  const bool cancelled = ImGui::IsKeyPressed(key::kEscape, false), held = ImGui::IsMouseDown(ImGuiMouseButton_Right);
  if (held && !cancelled) return;
  aimed_at.reset();
  if (!cancelled && ImGui::IsItemHovered()) issue(panel, {.name = "simulation.fire", .cursor = cursor});
}

void draw_aim(const Panel& panel) {
  if (!panel.state.aimed_at || panel.input.aim.flight.size() < 2) return;
  const Aim& aim = panel.input.aim;
  ImDrawList* list = ImGui::GetWindowDrawList();
  std::vector<RegionLine> lines;
  for (std::size_t i = 1; i < aim.flight.size(); ++i) lines.push_back({aim.flight[i - 1], aim.flight[i]});
  draw_world_lines(panel, list, lines, {}, kHeldColor);
  if (aim.hits) draw_impact(panel, list, aim.flight.back());
  const std::string text = (aim.hits ? "hits after " : "no hit within ") + format_quantity(aim.duration, "s", 3) +
                           ", " + format_quantity(length_of(aim.flight), "m", 3);
  draw_readout(panel, list, text);
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  tag_in_view(panel, "aim/readout", mouse, mouse, text);
}

}  // namespace griffith::ui
