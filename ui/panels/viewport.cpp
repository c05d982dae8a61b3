#include <cmath>

#include "ui/model/entry_choice.h"
#include "ui/model/entry_scale.h"
#include "ui/panels/overlays.h"
#include "ui/panels/panels.h"
#include "ui/panels/view_drawing.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace griffith::ui {
namespace {

constexpr float kOrbitPerHeight = 3.2f;  // radians for a drag over the picture's height
constexpr float kZoomPerNotch = 0.88f;
constexpr float kClickSlack = 4;  // design pixels that the mouse may move in a click

Vec2 place_in_viewport(const EditorState& state, ImVec2 mouse) {
  return {(mouse.x - state.viewport_minimum.x) / state.viewport_size.x,
          (mouse.y - state.viewport_minimum.y) / state.viewport_size.y};
}

/// Makes the view under the mouse the active one, unless a button went down in another.
void choose_view(EditorState& state, const Vec2& cursor) {
  if (ImGui::IsAnyMouseDown() && !ImGui::IsItemActivated()) return;
  const bool inside = cursor.minCoeff() >= 0 && cursor.maxCoeff() < 1;
  if (inside || !state.four_views.shown)
    state.four_views.active = view_at(state.four_views, cursor, state.viewport_size).view;
}

/// Moves the camera of the active view; those along an axis do not rotate.
void move_camera(EditorState& state, const ImGuiIO& io) {
  const FourViews& views = state.four_views;
  const bool left = ImGui::IsMouseDown(ImGuiMouseButton_Left), pans = views.active > 0 || io.KeyShift;
  const bool middle = ImGui::IsMouseDown(ImGuiMouseButton_Middle);
  const float height = area_of(views, views.active, state.viewport_size).size.y;
  const float speed = static_cast<float>(state.preferences.mouse_speed) / height;
  const float right = io.MouseDelta.x * speed, down = io.MouseDelta.y * speed;
  CameraMotion& motion = state.camera_motion;
  if (left && io.KeyCtrl) {
    motion.slice_right += right;
    motion.slice_up -= down;
  } else if (middle || (left && pans)) {
    motion.pan_right -= right;
    motion.pan_up += down;
  } else if (left) {
    motion.yaw -= kOrbitPerHeight * right;
    motion.pitch += kOrbitPerHeight * (state.preferences.invert_orbit ? -down : down);
  }
}

/// Asks for the piece below the mouse if a tool or a dragged material needs it.
void point_at_piece(EditorState& state, const Vec2& cursor) {
  const bool inside = cursor.minCoeff() >= 0 && cursor.maxCoeff() < 1;
  const bool needed = state.push_tool ? ImGui::IsItemHovered() : state.dragged_material.has_value();
  state.pointed_at = inside && needed ? std::optional(cursor) : std::nullopt;
}

void mouse_input(Panel& panel, const Vec2& cursor) {
  EditorState& state = panel.state;
  const ImGuiIO& io = ImGui::GetIO();
  const float slack = kClickSlack * ui_scale(panel);
  const bool hovered = ImGui::IsItemHovered();
  // Motion to the point where the button went down is no drag, though a slow frame sees both at once.
  if (ImGui::IsItemActive() && !ImGui::IsItemActivated()) move_camera(state, io);
  const float notches = state.preferences.invert_zoom ? -io.MouseWheel : io.MouseWheel;
  if (hovered && notches != 0) state.camera_motion.zoom *= std::pow(kZoomPerNotch, notches);
  aim_shot(panel, cursor);
  const bool clicked = ImGui::IsMouseReleased(ImGuiMouseButton_Left) && ImGui::IsItemDeactivated() &&
                       io.MouseDragMaxDistanceSqr[ImGuiMouseButton_Left] < slack * slack && !io.KeyShift;
  if (clicked) issue(panel, {.name = state.push_tool ? "simulation.push_at" : "view.pick", .cursor = cursor});
}

/// Returns the reason why no handles are shown; empty if they are.
std::string handles_hint(const Panel& panel) {
  if (panel.input.frame.step > 0) return "      R: reset, to edit bodies";
  const Scene& scene = panel.history.scene();
  const std::optional<SceneEntry> entry = active_entry(panel.state, scene);
  if (panel.state.gizmo != GizmoTool::scale || !entry) return "";
  const std::string problem(scale_problem(scene, *entry));
  return problem.empty() ? "" : "      " + problem;
}

void draw_hints(const Panel& panel, ImVec2 corner, ImVec2 end) {
  const Fonts& fonts = panel.input.fonts;
  const float scale = ui_scale(panel), size = fonts.small->FontSize, margin = 14 * scale;
  std::string text =
      "drag: orbit      shift+drag: pan      wheel: zoom      click: inspect      right click: fire (hold: aim)";
  if (panel.state.gizmo_drag || panel.state.region_drag)
    text = panel.state.snap ? "ctrl: do not snap      esc: cancel" : "ctrl: snap      esc: cancel";
  if (panel.state.four_views.active > 0)
    text = "drag: pan      wheel: zoom      click: inspect      right click: fire (hold: aim)";
  if (panel.input.microsteps) text = "space: play      left, N: one microstep      click: inspect      U: close";
  if (panel.state.grab_tool) text = "drag a piece: pull it by a spring      elsewhere: orbit      D: done";
  if (panel.state.push_tool) text = "click on a piece: push it      drag: orbit      I: done";
  if (panel.state.mouse_grabs) text = panel.state.running ? "release: let go" : "release: let go      space: run";
  if (panel.state.paint_regions) text = "drag on the body: paint      ctrl: erase      elsewhere: orbit      T: done";
  if (panel.state.aimed_at) text = "release: fire      esc: cancel";
  if (panel.state.gizmo != GizmoTool::none) text += handles_hint(panel);
  if (panel.state.view.slice) text += "      ctrl+drag: move the slice";
  const float width = fonts.small->CalcTextSizeA(size, FLT_MAX, 0, text.c_str()).x + 24 * scale;
  if (end.x - corner.x < width + 2 * margin) return;
  ImDrawList* list = ImGui::GetWindowDrawList();
  const ImVec2 low = {corner.x + margin, end.y - margin - size - 12 * scale};
  draw_card(list, low, {low.x + width, end.y - margin}, scale);
  list->AddText(fonts.small, size, {low.x + 12 * scale, low.y + 6 * scale}, palette::kTextDim, text.c_str());
}

void draw_pause_mark(const Panel& panel, ImVec2 corner) {
  if (panel.state.running || (panel.state.microsteps && panel.state.microsteps->playing)) return;
  const float scale = ui_scale(panel), margin = 14 * scale;
  ImDrawList* list = ImGui::GetWindowDrawList();
  const ImVec2 low = {corner.x + margin, corner.y + margin}, high = {low.x + 96 * scale, low.y + 30 * scale};
  draw_card(list, low, high, scale);
  draw_icon(list, Icon::pause, {low.x + 18 * scale, (low.y + high.y) / 2}, 14 * scale, palette::kAccent);
  list->AddText({low.x + 34 * scale, (low.y + high.y - ImGui::GetFontSize()) / 2}, palette::kText, "Paused");
}

/// Returns the left end of the legend in the upper right corner, or the right end of the picture without one.
float end_of_free_top(const Panel& panel, ImVec2 corner, ImVec2 end) {
  const std::optional<Legend>& legend = panel.input.views.front().legend;
  const float scale = ui_scale(panel);
  if (!legend || legend->corner != LegendCorner::upper_right || panel.state.four_views.count() > 1) return end.x;
  if (!legend_fits({corner, end}, scale)) return end.x;
  return legend_card(*legend, legend->corner, panel.input.fonts, {corner, end}, scale).minimum.x;
}

constexpr float kHoldingWidth = 206, kStoppedNodeWidth = 190, kStopButtonGap = 8;  // [design pixels]

/// True if the node before whose crack the run has stopped is not the selected one.
bool looks_elsewhere(const Panel& panel) {
  return panel.state.stop->node.valid() && panel.state.selection.node != panel.state.stop->node;
}

/// Returns the width of the buttons on the card of a stop [pixels].
float stop_buttons_width(const Panel& panel) {
  const float back = looks_elsewhere(panel) ? kStopButtonGap + kStoppedNodeWidth : 0;
  return (kHoldingWidth + back) * ui_scale(panel);
}

/// Draws the search for the value that would have held, and the way back to the node.
void draw_stop_buttons(Panel& panel) {
  const auto button = [&](const char* tag, std::string_view command, float width) {
    const CommandInfo& info = command_info(command, panel);
    if (text_button(panel, tag, info.label.data(), width * ui_scale(panel))) issue(panel, {.name = info.name});
  };
  button("time/holding", "time.holding", kHoldingWidth);
  if (!looks_elsewhere(panel)) return;
  ImGui::SameLine(0, kStopButtonGap * ui_scale(panel));
  button("time/stopped_node", "time.stopped_node", kStoppedNodeWidth);
}

/// Shows the reason why the simulation stopped by itself.
void draw_stop_card(Panel& panel, ImVec2 corner, ImVec2 end) {
  const float height = stop_card_height(panel);
  if (height == 0) return;
  const std::string& reason = panel.state.stop->reason;
  const bool can_explain = panel.state.stop->node.valid();
  const float scale = ui_scale(panel), margin = 14 * scale, padding = 12 * scale;
  const float width = std::max(ImGui::CalcTextSize(reason.c_str()).x, stop_buttons_width(panel)) + 2 * padding;
  const float most = end_of_free_top(panel, corner, end) - width - margin / 2;  // between other cards
  const ImVec2 low = {std::max(corner.x, std::min((corner.x + end.x - width) / 2, most)), corner.y + margin};
  draw_card(ImGui::GetWindowDrawList(), low, {low.x + width, low.y + height}, scale);
  ImGui::SetCursorScreenPos({low.x + padding, low.y + padding / 2});
  ImGui::TextColored(as_vec4(palette::kWarning), "%s", reason.c_str());
  tag_last_item(panel.tags, "time/stopped", reason);
  if (!can_explain) return;
  ImGui::SetCursorScreenPos({low.x + padding, low.y + padding / 2 + ImGui::GetFontSize() + 6 * scale});
  draw_stop_buttons(panel);
}

/// Handles the mouse in the active view.
void handle_mouse(Panel& panel) {
  EditorState& state = panel.state;
  ImGui::InvisibleButton("##view", state.viewport_size,
                         ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonMiddle);
  tag_last_item(panel.tags, "viewport");
  ImGui::SetItemAllowOverlap();  // cards and names of views have buttons
  const Vec2 cursor = place_in_viewport(state, ImGui::GetIO().MousePos);
  choose_view(state, cursor);
  panel.view = state.four_views.active;
  drop_material_on_view(panel);
  point_at_piece(state, cursor);
  if (!paint_region(panel) && !drag_region(panel) && !drag_gizmo(panel) && !drag_piece(panel, cursor))
    mouse_input(panel, cursor);
}

/// Draws the picture of the view and what lies over it.
void draw_view(Panel& panel) {
  const ShownView& view = panel.input.views[static_cast<std::size_t>(panel.view)];
  const ScreenArea area = view_area(panel);
  ImDrawList* list = ImGui::GetWindowDrawList();
  ImGui::PushClipRect(area.minimum, area.maximum, true);
  if (view.picture) list->AddImage(view.picture, area.minimum, area.maximum, {0, 1}, {1, 0});
  if (panel.view == 0) draw_comparison(panel);
  draw_labels(list, view.labels, panel.input.fonts, area.minimum, area.maximum, ui_scale(panel));
  draw_region(panel);
  draw_painted_region(panel);
  draw_coming_crack(panel);
  draw_symbol(panel);
  draw_gizmo(panel);
  draw_aim(panel);
  draw_grab(panel);
  draw_push(panel);
  draw_material_target(panel);
  if (view.legend && legend_fits(area, ui_scale(panel)))
    draw_legend(list, *view.legend, panel.input.fonts, area, ui_scale(panel));
  ImGui::PopClipRect();
}

}  // namespace

float stop_card_height(const Panel& panel) {
  if (!panel.state.stop || panel.state.microsteps) return 0;
  const float scale = ui_scale(panel), padding = 12 * scale;
  const float button = panel.state.stop->node.valid() ? ImGui::GetFrameHeight() + 8 * scale : 0;
  return button + ImGui::GetFontSize() + padding;
}

void draw_card(ImDrawList* list, ImVec2 low, ImVec2 high, float scale) {
  list->AddRectFilled(low, high, IM_COL32(24, 27, 32, 200), 6 * scale);
}

void draw_viewport(Panel& panel) {
  EditorState& state = panel.state;
  state.viewport_minimum = ImGui::GetCursorScreenPos();
  const ImVec2 room = ImGui::GetContentRegionAvail();
  state.viewport_size = {std::max(room.x, 16.0f), std::max(room.y, 16.0f)};
  handle_mouse(panel);
  for (panel.view = 0; panel.view < state.four_views.count(); ++panel.view) draw_view(panel);
  panel.view = 0;
  draw_view_names(panel);
  const ImVec2 end = {state.viewport_minimum.x + state.viewport_size.x,
                      state.viewport_minimum.y + state.viewport_size.y};
  draw_hints(panel, state.viewport_minimum, end);
  draw_pause_mark(panel, state.viewport_minimum);
  draw_view_warnings(panel, state.viewport_minimum);
  draw_stop_card(panel, state.viewport_minimum, end);
}

}  // namespace griffith::ui
