#include <string>

#include "ui/model/units.h"
#include "ui/panels/overlays.h"
#include "ui/panels/view_drawing.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace griffith::ui {
namespace {

/// Draws a ring and an arrow at the point of a push.
void draw_mark(const Panel& panel, ImDrawList* list, const PushMark& mark) {
  constexpr double kArrow = 70;  // design pixels
  constexpr float kRadius = 9;
  const ViewCamera camera = view_camera(panel);
  const std::optional<Vec2> pixel = camera.pixel(mark.point);
  if (!pixel) return;
  const float scale = ui_scale(panel);
  const double length = kArrow * scale * camera.pixel_length(mark.point);
  draw_world_lines(panel, list, {{mark.point - length * mark.impulse.normalized(), mark.point}}, {}, kHeldColor);
  const ImVec2 center = on_screen(panel, *pixel);
  list->AddCircle(center, kRadius * scale, kRimColor, 0, 4 * scale);
  list->AddCircle(center, kRadius * scale, kHeldColor, 0, 2 * scale);
  list->AddCircleFilled(center, 2 * scale, kHeldColor);
}

/// Describes the push of a piece: "4 m/s on 2.5 kg: 10 N·s".
std::string preview_of(const Panel& panel, const BodyView& piece) {
  const double speed = panel.state.push_speed;
  const std::string impulse = format_quantity(speed * piece.mass, "N·s", 3),
                    mass = format_quantity(piece.mass, "kg", 3);
  return piece.supported ? impulse + " on " + mass + ", which supports hold"
                         : format_quantity(speed, "m/s", 3) + " on " + mass + ": " + impulse;
}

}  // namespace

void draw_push(Panel& panel) {
  constexpr std::int64_t kShownSteps = 20;
  ImDrawList* list = ImGui::GetWindowDrawList();
  const std::int64_t step = panel.input.frame.step;
  const std::optional<PushMark>& mark = panel.state.push_mark;
  if (mark && step >= mark->step && step < mark->step + kShownSteps) draw_mark(panel, list, *mark);
  if (!panel.state.push_tool || !panel.state.pointed_at || !panel.input.pointed.valid()) return;
  const std::string text = preview_of(panel, panel.input.frame.bodies[panel.input.pointed]);
  draw_readout(panel, list, text);
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  tag_in_view(panel, "push/readout", mouse, mouse, text);
}

}  // namespace griffith::ui
