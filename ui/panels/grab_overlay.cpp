#include <string>

#include "ui/model/units.h"
#include "ui/panels/overlays.h"
#include "ui/panels/view_drawing.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace griffith::ui {
namespace {

constexpr double kAtLimit = 0.999;  // of the greatest force

bool begins_grab(const EditorState& state) {
  const ImGuiIO& io = ImGui::GetIO();
  return state.grab_tool && ImGui::IsItemActivated() && ImGui::IsMouseClicked(ImGuiMouseButton_Left) && !io.KeyShift &&
         !io.KeyCtrl;
}

/// Returns force and greatest force: "142 N of 600 N".
std::string readout_of(const GrabView& grab) {
  return format_quantity(grab.force.norm(), "N", 3) + " of " + format_quantity(grab.max_force, "N", 3);
}

}  // namespace

bool drag_piece(Panel& panel, const Vec2& cursor) {
  EditorState& state = panel.state;
  if (state.grab_tool && ImGui::IsItemHovered()) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
  if (begins_grab(state)) {
    state.mouse_grabs = true;
    issue(panel, {.name = "simulation.grab_at", .cursor = cursor});
    return true;
  }
  if (!state.mouse_grabs) return false;
  state.mouse_grabs =
      state.holds_piece && ImGui::IsMouseDown(ImGuiMouseButton_Left) && !ImGui::IsKeyPressed(key::kEscape, false);
  if (!state.holds_piece) return false;  // there was no piece, or the run went on without it
  const ImVec2 way = ImGui::GetIO().MouseDelta;
  if (!state.mouse_grabs) {
    issue(panel, {.name = "simulation.release"});
  } else if (way.x != 0 || way.y != 0) {
    issue(panel, {.name = "simulation.drag_to", .cursor = cursor});
  }
  return true;
}

void draw_grab(const Panel& panel) {
  const std::optional<GrabView>& grab = panel.input.frame.grab;
  if (!grab) return;
  ImDrawList* list = ImGui::GetWindowDrawList();
  const bool at_limit = grab->force.norm() >= kAtLimit * grab->max_force;
  const ImU32 color = at_limit ? palette::kWarning : kHeldColor;
  draw_world_lines(panel, list, {{grab->point, grab->target}}, {}, color);
  const ViewCamera camera = view_camera(panel);
  const float scale = ui_scale(panel);
  if (const std::optional<Vec2> point = camera.pixel(grab->point)) {
    list->AddCircleFilled(on_screen(panel, *point), 5 * scale, kRimColor);
    list->AddCircleFilled(on_screen(panel, *point), 4 * scale, color);
  }
  const std::optional<Vec2> target = camera.pixel(grab->target);
  if (!target) return;
  const ImVec2 end = on_screen(panel, *target);
  const std::string text = readout_of(*grab);
  list->AddCircle(end, 6 * scale, color, 0, 2 * scale);
  draw_readout(panel, list, text, end);
  tag_in_view(panel, "grab/readout", end, end, text);
}

}  // namespace griffith::ui
