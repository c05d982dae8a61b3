#include <algorithm>
#include <string>

#include "ui/panels/overlays.h"
#include "ui/panels/view_drawing.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace griffith::ui {
namespace {

constexpr ImU32 kGhost = IM_COL32(255, 255, 255, 115);

/// Returns the part of the screen with the view: corner and size.
ViewArea area(const Panel& panel) {
  const auto [low, end] = view_area(panel);
  return {low, {end.x - low.x, end.y - low.y}};
}

/// Draws the part of the view right of `border`, 0..1 of its width.
void draw_right_part(const Panel& panel, float border, ImU32 tint) {
  const auto [low, size] = area(panel);
  ImGui::GetWindowDrawList()->AddImage(panel.input.comparison->picture, {low.x + border * size.x, low.y},
                                       {low.x + size.x, low.y + size.y}, {border, 1}, {1, 0}, tint);
}

/// Draws the border between the pictures: a line with a grip that can be dragged.
void drag_border(Panel& panel) {
  EditorState& state = panel.state;
  const auto [low, size] = area(panel);
  const float scale = ui_scale(panel), reach = 6 * scale, x = low.x + state.comparison.border * size.x;
  ImGui::SetCursorScreenPos({x - reach, low.y});
  ImGui::InvisibleButton("##border", {2 * reach, size.y});
  tag_last_item(panel.tags, "compare/border", std::to_string(std::lround(100 * state.comparison.border)) + " %");
  const bool is_held = ImGui::IsItemActive();
  if (is_held) state.comparison.border = std::clamp((ImGui::GetIO().MousePos.x - low.x) / size.x, 0.02f, 0.98f);
  if (is_held || ImGui::IsItemHovered()) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
  ImDrawList* list = ImGui::GetWindowDrawList();
  list->AddLine({x, low.y}, {x, low.y + size.y}, palette::kAccent, 2 * scale);
  list->AddCircleFilled({x, low.y + size.y / 2}, 5 * scale, palette::kAccent);
}

/// Draws text on a card and tags it. `corner`, `width`: of the text.
void draw_card_text(Panel& panel, const char* tag, ImVec2 corner, float width, const std::string& text) {
  const float scale = ui_scale(panel), padding = 8 * scale;
  const ImVec2 size = ImGui::CalcTextSize(text.c_str(), nullptr, false, width);
  const ImVec2 low = {corner.x - padding, corner.y - padding / 2};
  const ImVec2 high = {corner.x + size.x + padding, corner.y + size.y + padding / 2};
  ImDrawList* list = ImGui::GetWindowDrawList();
  draw_card(list, low, high, scale);
  list->AddText(nullptr, 0, corner, palette::kText, text.c_str(), nullptr, width);
  panel.tags.push_back({tag, low, high, text});
}

/// Labels the branches on both sides of the border, below the card that says why the simulation stopped.
void draw_names(Panel& panel) {
  const float scale = ui_scale(panel), gap = 16 * scale, stop = stop_card_height(panel);
  const auto [low, size] = area(panel);
  const float x = low.x + panel.state.comparison.border * size.x;
  const float y = low.y + (18 + (stop > 0 ? 14 : 0)) * scale + stop;
  const std::string left = "branch " + std::to_string(panel.input.time.branch);
  const std::string right = "branch " + std::to_string(panel.input.comparison->branch);
  draw_card_text(panel, "compare/left", {x - gap - ImGui::CalcTextSize(left.c_str()).x, y}, 0, left);
  draw_card_text(panel, "compare/right", {x + gap, y}, 0, right);
}

/// Describes the difference of the branches, above the hints.
void draw_difference(Panel& panel) {
  const std::string& text = panel.input.comparison->text;
  const auto [low, size] = area(panel);
  const float scale = ui_scale(panel), margin = 22 * scale, width = size.x - 2 * margin;
  const float height = ImGui::CalcTextSize(text.c_str(), nullptr, false, width).y;
  draw_card_text(panel, "compare/difference", {low.x + margin, low.y + size.y - 58 * scale - height}, width, text);
}

}  // namespace

void draw_comparison(Panel& panel) {
  if (!panel.input.comparison) return;
  if (panel.state.comparison.as_ghost) {
    draw_right_part(panel, 0, kGhost);
  } else {
    draw_right_part(panel, panel.state.comparison.border, IM_COL32_WHITE);
    drag_border(panel);
    draw_names(panel);
  }
  draw_difference(panel);
}

}  // namespace griffith::ui
