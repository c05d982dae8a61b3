#include "ui/panels/side_panels.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "ui/panels/panels.h"
#include "ui/panels/window_flags.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace griffith::ui {
namespace {

/// A section of a side panel.
struct Section {
  std::string_view name;
  const char* title;  ///< shown while it is folded
  void (*draw)(Panel& panel);
  bool is_dense = false;  ///< rows of numbers are more compact than widgets
};

constexpr Section kSections[] = {{"outliner", "Outliner", draw_outliner_panel},
                                 {"handles", "Handles", draw_handles_panel},
                                 {"entry", "Selected entry", draw_entry_panel},
                                 {"materials", "Materials", draw_material_list},
                                 {"scene", "Scene", draw_scene_panel},
                                 {"grab", "Grab", draw_grab_panel},
                                 {"push", "Push", draw_push_panel},
                                 {"projectile", "Projectile", draw_projectile_panel},
                                 {"view", "View", draw_view_panel},
                                 {"symbol", "Symbol", draw_symbol_panel, true},
                                 {"inspector", "Why it broke or holds", draw_inspector_panel, true},
                                 {"statistics", "Simulation", draw_statistics_panel, true}};

/// Lets the mouse fold a section by a click on its grip, or take it by a drag. Call it before the section is drawn.
void handle_grip(Panel& panel, const SectionArea& area) {
  EditorState& state = panel.state;
  const ImVec2 start = ImGui::GetCursorScreenPos();
  const float size = ImGui::GetTextLineHeight() + 4 * ui_scale(panel);
  const float right = start.x + ImGui::GetContentRegionAvail().x;
  ImGui::SetCursorScreenPos({right - size, start.y});
  ImGui::InvisibleButton(("##grip" + area.name).c_str(), {size, size});
  tag_last_item(panel.tags, "section/" + area.name,
                state.preferences.sections.folded.contains(area.name) ? "folded" : "");
  tooltip("Click: fold or unfold. Drag: move to another place or side.");
  const bool held = ImGui::IsItemActive();
  if (held && ImGui::IsMouseDragging(ImGuiMouseButton_Left)) state.moved_section = area.name;
  const bool clicked = ImGui::IsItemDeactivated() && ImGui::IsItemHovered() && !state.moved_section;
  std::set<std::string>& folded = state.preferences.sections.folded;
  if (clicked && folded.erase(area.name) == 0) folded.insert(area.name);
  ImGui::SetCursorScreenPos(start);
}

/// Draws six dots at the right end of the section's first line while the mouse is on it.
void draw_grip(const Panel& panel, const SectionArea& area) {
  const float scale = ui_scale(panel), line = ImGui::GetTextLineHeight() + 4 * scale;
  const bool hovered = ImGui::IsWindowHovered(ImGuiHoveredFlags_AllowWhenBlockedByActiveItem) &&
                       ImGui::IsMouseHoveringRect(area.low, {area.high.x, area.low.y + line});
  if (!hovered && panel.state.moved_section != area.name) return;
  for (const int column : {0, 1})
    for (const int row : {-1, 0, 1})
      ImGui::GetWindowDrawList()->AddCircleFilled({area.high.x - (6 + 5 * static_cast<float>(column)) * scale,
                                                   area.low.y + line / 2 + 5 * static_cast<float>(row) * scale},
                                                  1.5f * scale, palette::kTextDim);
}

void draw_content(Panel& panel, const Section& section) {
  if (panel.state.preferences.sections.folded.contains(std::string(section.name))) {
    ImGui::TextColored(as_vec4(palette::kTextDim), "%s", section.title);
    return ImGui::Separator();
  }
  if (!section.is_dense) return section.draw(panel);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ImGui::GetStyle().ItemSpacing.x, 3 * ui_scale(panel)});
  section.draw(panel);
  ImGui::PopStyleVar();
}

/// Draws a section and records where it is. `last`: the sections of the last frame; only what was there has a grip.
void draw_section(Panel& panel, const Section& section, bool is_left, const std::vector<SectionArea>& last) {
  SectionArea area{std::string(section.name), is_left, ImGui::GetCursorScreenPos(), {}};
  if (std::ranges::find(last, area.name, &SectionArea::name) != last.end()) handle_grip(panel, area);
  draw_content(panel, section);
  area.high = {area.low.x + ImGui::GetContentRegionAvail().x, ImGui::GetCursorScreenPos().y};
  if (area.high.y <= area.low.y) return;  // sections of tools that are off
  draw_grip(panel, area);
  panel.state.section_areas.push_back(std::move(area));
}

/// Begins a side panel; updates `width` [pixels] and `kept` [design pixels].
void begin_side(const Panel& panel, const char* name, float x, float top, float height, float& width, double& kept) {
  const float scale = ui_scale(panel);
  const ImGuiCond once = width == 0 ? ImGuiCond_Always : ImGuiCond_Once;
  if (width == 0) width = static_cast<float>(kept) * scale;
  ImGui::SetNextWindowSize({width, height}, once);
  ImGui::SetNextWindowSizeConstraints({static_cast<float>(kSideWidths.minimum) * scale, height},
                                      {static_cast<float>(kSideWidths.maximum) * scale, height});
  ImGui::SetNextWindowPos({x < 0 ? -x - width : x, top});
  ImGui::Begin(name, nullptr, kFixedWindow);
  width = ImGui::GetWindowWidth();
  const double dragged = std::clamp(static_cast<double>(width / scale), kSideWidths.minimum, kSideWidths.maximum);
  if (std::abs(dragged - kept) > 1) kept = dragged;  // smaller differences come from whole pixels
}

void draw_sections(Panel& panel, bool is_left, const std::vector<SectionArea>& last) {
  const std::vector<std::string> names = panel.state.preferences.sections.side(is_left);
  for (const std::string& name : names)
    if (const auto section = std::ranges::find(kSections, name, &Section::name); section != std::end(kSections))
      draw_section(panel, *section, is_left, last);
  ImGui::End();
}

/// Moves the section that is dragged to where it is dropped. Escape cancels.
void drop_section(Panel& panel, float middle) {
  std::optional<std::string>& moved = panel.state.moved_section;
  if (!moved) return;
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  const bool to_left = mouse.x < middle;
  std::string before;
  ImVec2 low, high;  // the line at which it would be dropped
  for (const SectionArea& area : panel.state.section_areas) {
    if (area.is_left != to_left) continue;
    const bool is_below = before.empty() && mouse.y < (area.low.y + area.high.y) / 2;
    if (is_below) before = area.name;
    if (before.empty() || is_below)
      low = {area.low.x, is_below ? area.low.y : area.high.y}, high = {area.high.x, low.y};
  }
  ImGui::GetForegroundDrawList()->AddLine(low, high, palette::kAccent, 3 * ui_scale(panel));
  const bool cancelled = ImGui::IsKeyPressed(key::kEscape, false);
  if (ImGui::IsMouseDown(ImGuiMouseButton_Left) && !cancelled) return;
  if (!cancelled) move_section(panel.state.preferences.sections, *moved, to_left, before);
  moved.reset();
}

}  // namespace

void reset_layout(EditorState& state) {
  const Preferences usual;
  Preferences& mine = state.preferences;
  mine.left_width = usual.left_width, mine.right_width = usual.right_width;
  mine.plots_height = mine.log_height = mine.problems_height = 0;
  mine.show_left = mine.show_right = true;
  mine.sections = usual.sections;
  state.left_width = state.right_width = 0;
  state.plots.height = state.log_view.height = state.problem_view.height = 0;
  state.four_views = {};
}

void draw_side_panels(Panel& panel, ImVec2 corner, ImVec2 end) {
  EditorState& state = panel.state;
  Preferences& preferences = state.preferences;
  if (state.sought.frames > 0) preferences.sections.folded.clear();
  const std::vector<SectionArea> last = std::exchange(state.section_areas, {});
  const float height = end.y - corner.y;
  if (!preferences.show_left) state.left_width = 0;
  if (!preferences.show_right) state.right_width = 0;
  if (preferences.show_left) {
    begin_side(panel, "##left", corner.x, corner.y, height, state.left_width, preferences.left_width);
    draw_sections(panel, true, last);
  }
  if (preferences.show_right) {
    begin_side(panel, "##right", -end.x, corner.y, height, state.right_width, preferences.right_width);
    draw_sections(panel, false, last);
  }
  drop_section(panel, (corner.x + end.x) / 2);
}

}  // namespace griffith::ui
