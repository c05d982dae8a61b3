#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "ui/panels/panels.h"
#include "ui/widgets/number_field.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace griffith::ui {
namespace {

constexpr std::array<const char*, 4> kCrackPlaces = {"none", "any", "of the selected body", "at the selected node"};
constexpr ImU32 kImpactColor = IM_COL32(102, 187, 240, 255);

/// Describes the events of the steps under the cursor.
std::string ticks_text(const TimeView& time, std::int64_t first, std::int64_t last) {
  int cracks = 0, impacts = 0;
  bool alarm = false;
  for (const TimeTick& tick : time.ticks)
    if (tick.step >= first && tick.step <= last) cracks += tick.cracks, impacts += tick.impacts, alarm |= tick.alarm;
  std::string text;
  const auto add = [&text](const std::string& part) { text += (text.empty() ? ": " : ", ") + part; };
  if (impacts > 0) add(impacts == 1 ? "1 body hit" : std::to_string(impacts) + " bodies hit");
  if (cracks > 0) add(std::to_string(cracks) + (cracks == 1 ? " crack" : " cracks"));
  if (alarm) add("numerical problems");
  return text;
}

/// Mapping of steps to the timeline.
struct Scale {
  ImVec2 low, high;
  std::int64_t first, steps;

  float x(double step) const {
    return low.x +
           (high.x - low.x) * static_cast<float>((step - static_cast<double>(first)) / static_cast<double>(steps));
  }
  float x(std::int64_t step) const { return x(static_cast<double>(step)); }
  std::int64_t step_at(float place) const {
    const float fraction = std::clamp((place - low.x) / (high.x - low.x), 0.0f, 1.0f);
    return first + std::llround(static_cast<double>(fraction) * static_cast<double>(steps));
  }
};

/// Draws ticks: cracks grow with the logarithm of their number; impacts and alarms hang from above.
void draw_ticks(const Panel& panel, const Scale& bar) {
  ImDrawList* list = ImGui::GetWindowDrawList();
  const float scale = ui_scale(panel), height = bar.high.y - bar.low.y;
  for (const TimeTick& tick : panel.input.time.ticks) {
    const float x = bar.x(tick.step);
    const float length = height * std::min(1.0f, 0.35f + 0.15f * std::log2(1.0f + static_cast<float>(tick.cracks)));
    if (tick.cracks > 0)
      list->AddLine({x, bar.high.y - length}, {x, bar.high.y}, palette::kError, std::max(1.0f, 1.5f * scale));
    if (tick.impacts > 0)
      list->AddLine({x, bar.low.y}, {x, bar.low.y + 0.25f * height}, kImpactColor, std::max(1.0f, 1.5f * scale));
    if (tick.alarm) list->AddLine({x, bar.low.y}, {x, bar.low.y + 0.3f * height}, palette::kWarning, 2 * scale);
  }
}

/// Draws the past of the branch: a click or a drag goes there.
void draw_bar(Panel& panel, float width) {
  const TimeView& time = panel.input.time;
  const float scale = ui_scale(panel), height = ImGui::GetFrameHeight();
  ImGui::InvisibleButton("##time", {width, height});
  const std::int64_t now = panel.input.frame.step;
  tag_last_item(panel.tags, "time/bar", std::to_string(now) + " of " + std::to_string(time.last_step));
  const Scale bar{ImGui::GetItemRectMin(), ImGui::GetItemRectMax(), time.first_step,
                  std::max<std::int64_t>(1, time.last_step - time.first_step)};
  ImDrawList* list = ImGui::GetWindowDrawList();
  list->AddRectFilled(bar.low, bar.high, palette::kField, 3 * scale);
  if (time.branch > 0) {
    const float start = bar.x(time.branches[time.branch].first_step);
    list->AddRectFilled({start, bar.high.y - 3 * scale}, bar.high, palette::kAccent);
  }
  draw_ticks(panel, bar);
  const double place = panel.input.microsteps ? panel.input.frame.time / time.time_step : static_cast<double>(now);
  const float shown = bar.x(place);
  list->AddLine({shown, bar.low.y}, {shown, bar.high.y}, palette::kText, 2 * scale);
  const std::int64_t pointed = bar.step_at(ImGui::GetIO().MousePos.x);
  if (ImGui::IsItemActive() && (pointed != now || panel.input.microsteps))
    issue(panel, {.name = "time.step", .step = pointed});
  if (ImGui::IsItemHovered() || ImGui::IsItemActive()) {
    const std::int64_t reach =
        std::max<std::int64_t>(0, std::llround(3 * scale / (bar.high.x - bar.low.x) * bar.steps));
    ImGui::SetTooltip("%s%s", step_text(time, pointed).c_str(),
                      ticks_text(time, pointed - reach, pointed + reach).c_str());
  }
}

/// Names a branch: "branch 1, from step 40 of branch 0".
std::string branch_text(const TimeView& time, int branch) {
  const TimeView::BranchView& view = time.branches[branch];
  std::string text = "branch " + std::to_string(branch);
  if (view.parent >= 0)
    text += ", from step " + std::to_string(view.first_step) + " of branch " + std::to_string(view.parent);
  return text + ", to step " + std::to_string(view.last_step);
}

/// Returns the number of ancestors of a branch.
int depth_of(const TimeView& time, int branch) {
  int depth = 0;
  for (; time.branches[branch].parent >= 0; branch = time.branches[branch].parent) ++depth;
  return depth;
}

void branch_list(Panel& panel) {
  const TimeView& time = panel.input.time;
  ImGui::SetNextItemWidth(110 * ui_scale(panel));
  const std::string shown = "branch " + std::to_string(time.branch);
  const bool open = begin_combo("##branch", shown.c_str());
  if (open) {
    for (int i = 0; i < static_cast<int>(time.branches.size()); ++i) {
      const std::string text = std::string(3 * static_cast<std::size_t>(depth_of(time, i)), ' ') + branch_text(time, i);
      if (ImGui::Selectable(text.c_str(), i == time.branch))
        issue(panel, {.name = "time.branch", .step = time.branches[i].last_step, .branch = i});
      tag_last_item(panel.tags, "time/branch/" + std::to_string(i), text);
    }
    ImGui::EndCombo();
  }
  tag_last_item(panel.tags, "time/branch", shown);
  if (!open) tooltip("Changes in the past start a new branch.");
}

/// Draws the choice of the compared branch and the style of the comparison.
void comparison_fields(Panel& panel) {
  Comparison& comparison = panel.state.comparison;
  const auto choice = [&](const std::string& text, const char* name, std::optional<int> branch) {
    if (ImGui::RadioButton(text.c_str(), comparison.branch == branch)) comparison.branch = branch;
    tag_last_item(panel.tags, std::string("compare/") + name, comparison.branch == branch ? "on" : "off");
  };
  choice("no comparison", "none", std::nullopt);
  for (int i = 0; i < static_cast<int>(panel.input.time.branches.size()); ++i)
    if (i != panel.input.time.branch) choice(branch_text(panel.input.time, i), std::to_string(i).c_str(), i);
  ImGui::Separator();
  checkbox(panel, "compare/ghost", "overlay", comparison.as_ghost);
  tooltip("Overlay the pictures instead of showing them side by side.");
}

/// True if the popup of the last button is open; begins it above the button, up to ImGui::EndPopup().
bool begin_popup_above(const Panel& panel, const char* popup) {
  const ImVec2 corner(ImGui::GetItemRectMax().x, ImGui::GetItemRectMin().y - 4 * ui_scale(panel));
  ImGui::SetNextWindowPos(corner, ImGuiCond_Appearing, {1, 1});
  if (!ImGui::BeginPopup(popup)) return false;
  close_on_escape();
  return true;
}

void comparison_button(Panel& panel) {
  const std::optional<int> branch = panel.state.comparison.branch;
  if (branch) ImGui::PushStyleColor(ImGuiCol_Text, palette::kAccent);
  if (ImGui::Button("Compare…")) ImGui::OpenPopup("##compare");
  if (branch) ImGui::PopStyleColor();
  tag_last_item(panel.tags, "time/compare", branch ? "with branch " + std::to_string(*branch) : "off");
  if (!begin_popup_above(panel, "##compare")) return;
  comparison_fields(panel);
  ImGui::EndPopup();
}

/// Returns the width of a button with that text and the gap after it.
float button_room(const char* text) {
  const ImGuiStyle& style = ImGui::GetStyle();
  return ImGui::CalcTextSize(text).x + 2 * style.FramePadding.x + style.ItemSpacing.x;
}

/// Draws a number that belongs to a check box.
void limit_field(Panel& panel, const char* tag, const Numbers& numbers, const char* meaning, double& value,
                 bool whole = false) {
  ImGui::SameLine();
  ImGui::SetNextItemWidth(90 * ui_scale(panel));
  number_field(panel, {.tag = tag, .label = {}, .numbers = numbers, .tooltip = meaning, .whole = whole}, value);
}

void breakpoint_fields(Panel& panel) {
  Breakpoints& points = panel.state.breakpoints;
  ImGui::TextUnformatted("Stop before a crack:");
  for (std::size_t i = 0; i < kCrackPlaces.size(); ++i) {
    if (ImGui::RadioButton(kCrackPlaces[i], points.crack == static_cast<Breakpoints::Where>(i)))
      points.crack = static_cast<Breakpoints::Where>(i);
    tag_last_item(panel.tags, std::string("time/break/") + kCrackPlaces[i], kCrackPlaces[i]);
  }
  ImGui::Separator();
  ImGui::TextUnformatted("Stop before a step in which");
  checkbox(panel, "time/break/on_utilization", "the utilization exceeds", points.on_utilization);
  limit_field(panel, "time/break/utilization", between(0, 100), "Load over resistance; a node cracks at 1.",
              points.utilization);
  checkbox(panel, "time/break/on_pieces", "the number of pieces reaches", points.on_pieces);
  double pieces = points.pieces;
  limit_field(panel, "time/break/pieces", between(1, 1e6), "An integer.", pieces, true);
  points.pieces = static_cast<int>(std::lround(pieces));
  checkbox(panel, "time/break/on_energy", "the unaccounted energy exceeds", points.on_energy);
  limit_field(panel, "time/break/energy", between(0, 1), "Fraction of the energy turnover of the step.", points.energy);
  checkbox(panel, "time/break/on_failure", "a solve fails or values are not finite", points.on_failure);
}

void breakpoint_button(Panel& panel) {
  const bool armed = panel.state.breakpoints.any();
  if (armed) ImGui::PushStyleColor(ImGuiCol_Text, palette::kWarning);
  if (ImGui::Button("Stop before…")) ImGui::OpenPopup("##breakpoints");
  if (armed) ImGui::PopStyleColor();
  tag_last_item(panel.tags, "time/breakpoints", armed ? "armed" : "none");
  tooltip("Conditions that stop the simulation: before a crack, not after it.");
  if (!begin_popup_above(panel, "##breakpoints")) return;
  breakpoint_fields(panel);
  ImGui::EndPopup();
}

/// Draws the button of the microsteps; dim while the shown step has none.
void microstep_button(Panel& panel) {
  const CommandInfo& info = command_info("time.microsteps", panel);
  const std::string_view reason = disabled_reason(info, panel);
  const ImU32 color = panel.state.microsteps ? palette::kAccent : reason.empty() ? palette::kText : palette::kTextDim;
  ImGui::PushStyleColor(ImGuiCol_Text, color);
  if (ImGui::Button("Microsteps")) issue(panel, {.name = info.name});
  ImGui::PopStyleColor();
  tag_last_item(panel.tags, "time/microsteps", panel.state.microsteps ? "shown" : reason.empty() ? "" : "none");
  tooltip(std::string(reason.empty() ? info.hint : reason).c_str());
}

}  // namespace

void draw_time_bar(Panel& panel) {
  command_button(panel, "time.start", Icon::to_start, false);
  ImGui::SameLine();
  command_button(panel, "time.back", Icon::step_back, false);
  ImGui::SameLine();
  const TimeView& time = panel.input.time;
  const float scale = ui_scale(panel), spacing = ImGui::GetStyle().ItemSpacing.x;
  const float branches = time.branches.size() > 1 ? 110 * scale + spacing + button_room("Compare…") : 0;
  const float stop = button_room("Stop before…") + button_room("Microsteps");
  const float end = 1.25f * ImGui::GetFrameHeight() + spacing;
  draw_bar(panel, std::max(40 * scale, ImGui::GetContentRegionAvail().x - branches - stop - end));
  ImGui::SameLine();
  command_button(panel, "time.end", Icon::to_end, false);
  ImGui::SameLine();
  if (branches > 0) {
    branch_list(panel);
    ImGui::SameLine();
    comparison_button(panel);
    ImGui::SameLine();
  }
  microstep_button(panel);
  ImGui::SameLine();
  breakpoint_button(panel);
}

}  // namespace griffith::ui
