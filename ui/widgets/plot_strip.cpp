#include "ui/widgets/plot_strip.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "ui/model/units.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace griffith::ui {
namespace {

constexpr float kAxisWidth = 58, kNamesHeight = 17, kStripMargin = 5;  // design pixels

/// Converts a point to pixels.
ImVec2 as_place(double x, double y) { return {static_cast<float>(x), static_cast<float>(y)}; }

/// Returns the view of the shown steps, in the full width of the item drawn last.
PlotView view_in_item(const Panel& panel, const PlotRange& range) {
  const StepSpan steps = shown_steps(panel);
  const float scale = ui_scale(panel);
  const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
  return {.left = low.x + kAxisWidth * scale,
          .right = high.x - kStripMargin * scale,
          .top = low.y + kNamesHeight * scale,
          .bottom = high.y - kStripMargin * scale,
          .first_step = steps.first,
          .last_step = steps.last,
          .time_step = panel.input.time.time_step,
          .range = range,
          .logarithmic = panel.state.preferences.logarithmic_plots};
}

/// Returns the unit of the numbers on the axis: "kJ".
std::string axis_unit(const std::string& unit, const SiPrefix& prefix) {
  return unit == "-" ? "" : std::string(prefix.symbol) + unit;
}

SiPrefix axis_prefix(const PlotRange& range, const std::string& unit) {
  return si_prefix(std::max(std::abs(range.low), std::abs(range.high)), unit);
}

/// Draws a line across the field with its number before it.
void draw_tick(const Panel& panel, const PlotView& view, double value, const std::string& text) {
  ImDrawList* list = ImGui::GetWindowDrawList();
  const float scale = ui_scale(panel);
  const double y = view.y(value);
  list->AddLine(as_place(view.left, y), as_place(view.right, y), palette::kLine, scale);
  const float x = static_cast<float>(view.left) - 6 * scale - ImGui::CalcTextSize(text.c_str()).x;
  list->AddText({x, static_cast<float>(y) - kSmallText * scale / 2}, palette::kTextDim, text.c_str());
}

/// Draws the numbers in the axis' unit; decades have prefixes of their own.
void draw_axis(const Panel& panel, const PlotView& view, const std::string& unit, const SiPrefix& prefix) {
  const double text_height = 1.4 * static_cast<double>(kSmallText * ui_scale(panel));
  const double count = legend_tick_count(view.bottom - view.top, text_height), factor = prefix.factor;
  if (view.logarithmic) {
    for (const double tick : decade_ticks(view.range, count))
      draw_tick(panel, view, tick, format_quantity(tick, unit == "-" ? "" : unit, 3));
    return;
  }
  for (const double tick : legend_ticks(view.range.low / factor, view.range.high / factor, count))
    draw_tick(panel, view, tick * factor, format_number(tick + 0.0, {}, 5));
}

/// Returns a translucent color, through which another curve of its kind is visible.
ImU32 paler(ImU32 color) { return (color & ~IM_COL32_A_MASK) | IM_COL32(0, 0, 0, 110); }

/// Draws a line through the columns, each as high as the range of its values.
void draw_curve(const Panel& panel, const PlotView& view, const RunCurve& curve, std::span<const double> times,
                ImU32 color) {
  ImDrawList* list = ImGui::GetWindowDrawList();
  const float width = 1.5f * ui_scale(panel);
  std::optional<ImVec2> end;
  for (const PlotColumn& column : plot_columns(times, curve.values, view.span(), view.floor())) {
    const double x = view.left + column.column + 0.5;
    if (end && !column.begins) list->AddLine(*end, as_place(x, view.y(column.first)), color, width);
    list->AddLine(as_place(x, view.y(column.low) + 0.5), as_place(x, view.y(column.high) - 0.5), color, width);
    end = as_place(x, view.y(column.last));
  }
}

/// Draws the unit and the names of the curves in their colors, above the field.
void draw_names(const Panel& panel, const PlotView& view, const PlotStrip& strip, const std::string& unit) {
  ImDrawList* list = ImGui::GetWindowDrawList();
  const float scale = ui_scale(panel), y = static_cast<float>(view.top) - kNamesHeight * scale;
  float x = static_cast<float>(view.left);
  list->AddText({x - 6 * scale - ImGui::CalcTextSize(unit.c_str()).x, y}, palette::kText, unit.c_str());
  for (const RunCurve* curve : strip.curves) {
    const std::string name = fitted(curve->series.label, static_cast<float>(view.right) - x);
    list->AddText({x, y}, plot_color(curve->slot), name.c_str());
    x += ImGui::CalcTextSize(name.c_str()).x + 14 * scale;
  }
}

/// Draws a vertical line at a step; nothing beyond the ends.
void draw_step_line(const PlotView& view, std::int64_t step, ImU32 color, float width) {
  if (step < view.first_step || step > view.last_step) return;
  const double x = view.x(step);
  ImGui::GetWindowDrawList()->AddLine(as_place(x, view.top), as_place(x, view.bottom), color, width);
}

/// Describes a strip: "Kinetic, Elastic [kJ]".
std::string strip_text(const PlotStrip& strip, const std::string& unit) {
  std::string text;
  for (const RunCurve* curve : strip.curves) text += (text.empty() ? "" : ", ") + curve->series.label;
  return unit.empty() ? text : text + " [" + unit + "]";
}

}  // namespace

ImU32 plot_color(std::size_t slot) {
  constexpr std::array<ImU32, kMaxPlotted> kColors = {IM_COL32(102, 187, 240, 255), IM_COL32(240, 160, 60, 255),
                                                      IM_COL32(90, 205, 150, 255),  IM_COL32(240, 225, 100, 255),
                                                      IM_COL32(225, 140, 205, 255), IM_COL32(240, 110, 95, 255)};
  return kColors[slot];
}

StepSpan shown_steps(const Panel& panel) {
  const StepSpan whole{panel.input.time.first_step, panel.input.time.last_step};
  return moved(panel.state.plots.zoom.value_or(whole), whole, 0);
}

PlotView draw_plot_strip(Panel& panel, const std::string& tag, const PlotStrip& strip, const PlotStrip* compared,
                         float height) {
  std::vector<const RunCurve*> all = strip.curves;
  if (compared) all.insert(all.end(), compared->curves.begin(), compared->curves.end());
  const bool logarithmic = panel.state.preferences.logarithmic_plots;
  const PlotRange range = logarithmic ? decade_range(all) : plot_range(all);
  const SiPrefix prefix = logarithmic ? SiPrefix{} : axis_prefix(range, strip.unit);
  const std::string unit = axis_unit(strip.unit, prefix);
  ImGui::InvisibleButton(tag.c_str(), {ImGui::GetContentRegionAvail().x, height});
  tag_last_item(panel.tags, tag, strip_text(strip, unit));
  const PlotView view = view_in_item(panel, range);
  const float scale = ui_scale(panel);
  ImGui::PushFont(panel.input.fonts.small);
  ImGui::GetWindowDrawList()->AddRectFilled(as_place(view.left, view.top), as_place(view.right, view.bottom),
                                            palette::kField);
  draw_axis(panel, view, strip.unit, prefix);
  draw_step_line(view, panel.input.frame.step, palette::kText, scale);
  if (compared)
    for (const RunCurve* curve : compared->curves)
      draw_curve(panel, view, *curve, compared->times, paler(plot_color(curve->slot)));
  for (const RunCurve* curve : strip.curves) draw_curve(panel, view, *curve, strip.times, plot_color(curve->slot));
  draw_names(panel, view, strip, unit);
  ImGui::PopFont();
  const float mouse = ImGui::GetIO().MousePos.x;
  const bool points = ImGui::IsWindowHovered(ImGuiHoveredFlags_AllowWhenBlockedByActiveItem);
  if (points && !panel.state.plots.for_picture && mouse >= static_cast<float>(view.left) &&
      mouse <= static_cast<float>(view.right))
    draw_step_line(view, view.step_at(static_cast<double>(mouse)), palette::kTextDim, scale);
  return view;
}

float plot_times_height(const Panel& panel) { return kNamesHeight * ui_scale(panel); }

void draw_plot_times(Panel& panel) {
  ImGui::Dummy({ImGui::GetContentRegionAvail().x, plot_times_height(panel)});
  const PlotView view = view_in_item(panel, {});
  const PlotSpan span = view.span();
  const float scale = ui_scale(panel), y = ImGui::GetItemRectMin().y;
  ImGui::PushFont(panel.input.fonts.small);
  if (span.end > span.start)
    for (const double tick : legend_ticks(span.start, span.end, std::max(1.0, span.columns / (90.0 * scale)))) {
      const std::string text = format_quantity(tick + 0.0, "s", 5);
      const float width = ImGui::CalcTextSize(text.c_str()).x;
      const double x = view.left + (tick - span.start) / (span.end - span.start) * (view.right - view.left);
      const float last = static_cast<float>(view.right) - width;  // the text at the end would be cut off
      ImGui::GetWindowDrawList()->AddText({std::min(static_cast<float>(x) - width / 2, last), y}, palette::kTextDim,
                                          text.c_str());
    }
  ImGui::PopFont();
}

}  // namespace griffith::ui
