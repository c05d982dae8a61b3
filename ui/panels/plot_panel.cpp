#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "ui/model/plot_view.h"
#include "ui/model/units.h"
#include "ui/panels/panels.h"
#include "ui/widgets/plot_strip.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace griffith::ui {
namespace {

constexpr float kListWidth = 130, kMinimumStrip = 56;  // design pixels

/// Draws an entry of the list, in the color of its curve if it is plotted.
void series_entry(Panel& panel, const RunSeries& series) {
  PlotChoice& chosen = panel.state.preferences.plotted;
  const std::span<const RunSeries> there = panel.input.series;
  const auto slot = std::ranges::find(chosen, series.key);
  const bool plotted = slot != chosen.end();
  if (plotted) ImGui::PushStyleColor(ImGuiCol_Text, plot_color(static_cast<std::size_t>(slot - chosen.begin())));
  ImGui::BeginDisabled(!plotted && count_series(chosen, there) == kMaxPlotted);
  const std::string label = series.label + "###" + series.key;
  if (ImGui::Selectable(label.c_str(), plotted, ImGuiSelectableFlags_DontClosePopups))
    toggle_series(chosen, series.key, there);
  ImGui::EndDisabled();
  if (plotted) ImGui::PopStyleColor();
  tag_last_item(panel.tags, "plots/series/" + series.key, plotted ? "on" : "off");
}

void series_list(Panel& panel) {
  ImGui::SetNextItemWidth(kListWidth * ui_scale(panel));
  const std::size_t count = count_series(panel.state.preferences.plotted, panel.input.series);
  const std::string shown = std::to_string(count) + " of " + std::to_string(kMaxPlotted) + " series";
  const bool open = begin_combo("##series", shown.c_str());
  if (open) {
    std::string group;
    for (const RunSeries& series : panel.input.series) {
      if (series.group != group) hint(panel, group = series.group);
      series_entry(panel, series);
    }
    ImGui::EndCombo();
  }
  tag_last_item(panel.tags, "plots/series", shown);
}

/// Draws the settings of the axes.
void scale_widgets(Panel& panel) {
  checkbox(panel, "plots/logarithmic", "log", panel.state.preferences.logarithmic_plots);
  tooltip("Logarithmic scale: equal distances are equal ratios. Only positive values are shown.");
  ImGui::SameLine();
  std::optional<StepSpan>& zoom = panel.state.plots.zoom;
  ImGui::BeginDisabled(!zoom);
  if (text_button(panel, "plots/whole", "All")) zoom.reset();
  ImGui::EndDisabled();
  tooltip("Show all steps. Over the curves, the wheel zooms and Shift+wheel scrolls.");
}

/// Draws the plotted series and the buttons.
void plots_bar(Panel& panel) {
  series_list(panel);
  ImGui::SameLine();
  scale_widgets(panel);
  ImGui::SameLine();
  ImGui::BeginDisabled(!command_enabled(command_info("file.plots", panel), panel));
  if (text_button(panel, "plots/save", "Save…")) issue(panel, {.name = "file.plots"});
  ImGui::EndDisabled();
  ImGui::SameLine();
  if (text_button(panel, "plots/close", "Close")) issue(panel, {.name = "view.plots"});
}

/// Returns the index of a recorded step; empty if it was not recorded.
std::optional<std::size_t> row_of(const RunCurves& curves, std::int64_t step) {
  const auto row = std::ranges::lower_bound(curves.steps, step);
  if (row == curves.steps.end() || *row != step) return std::nullopt;
  return static_cast<std::size_t>(row - curves.steps.begin());
}

/// Formats the value of a curve at a step, followed by that of the compared branch.
std::string value_text(const Panel& panel, std::size_t curve, std::int64_t step) {
  const auto text_in = [&](const RunCurves& curves) {
    const std::optional<std::size_t> row = row_of(curves, step);
    if (!row || curve >= curves.curves.size()) return std::string("-");
    return format_quantity(curves.curves[curve].values[*row], curves.curves[curve].series.unit, 4);
  };
  const std::string text = text_in(panel.input.curves);
  if (!panel.input.comparison) return text;
  return text + " | branch " + std::to_string(panel.input.comparison->branch) + ": " +
         text_in(panel.input.comparison->curves);
}

/// Shows the values of all curves at a step next to the mouse.
void values_tooltip(Panel& panel, std::int64_t step) {
  const RunCurves& curves = panel.input.curves;
  const bool recorded = row_of(curves, step).has_value();
  ImGui::BeginTooltip();
  ImGui::TextUnformatted((step_text(panel.input.time, step) + (recorded ? "" : ": not recorded")).c_str());
  tag_last_item(panel.tags, "plots/step", std::to_string(step));
  for (std::size_t i = 0; recorded && i < curves.curves.size(); ++i) {
    const RunCurve& curve = curves.curves[i];
    const std::string text = value_text(panel, i, step);
    ImGui::TextColored(as_vec4(plot_color(curve.slot)), "%s: %s", curve.series.label.c_str(), text.c_str());
    tag_last_item(panel.tags, "plots/value/" + curve.series.key, text);
  }
  ImGui::EndTooltip();
}

/// Lets a click or a drag in the strip drawn last go to a step.
void follow_mouse(Panel& panel, const PlotView& view) {
  if (panel.state.plots.for_picture) return;
  const bool held = ImGui::IsItemActive();
  if (!held && !ImGui::IsItemHovered()) return;
  const std::int64_t pointed = view.step_at(static_cast<double>(ImGui::GetIO().MousePos.x));
  if (held && pointed != panel.input.frame.step) issue(panel, {.name = "time.step", .step = pointed});
  values_tooltip(panel, pointed);
}

/// Lets the wheel zoom over the curves and pan with Shift; over the axes it scrolls.
void follow_wheel(Panel& panel, const PlotView& view) {
  constexpr double kFactor = 0.8, kPartMoved = 0.1;
  const ImGuiIO& io = ImGui::GetIO();
  const float turned = io.MouseWheel, aside = io.MouseWheelH;
  if ((turned == 0 && aside == 0) || !ImGui::IsItemHovered()) return;
  const double place = static_cast<double>(io.MousePos.x);
  if (place < view.left) return ImGui::SetScrollY(ImGui::GetScrollY() - turned * 3 * ImGui::GetTextLineHeight());
  const StepSpan whole{panel.input.time.first_step, panel.input.time.last_step}, shown = shown_steps(panel);
  const double length = kPartMoved * static_cast<double>(shown.last - shown.first);
  const float notches = io.KeyShift ? -turned : aside;
  const StepSpan changed = notches != 0
                               ? moved(shown, whole, std::llround(static_cast<double>(notches) * std::max(1.0, length)))
                               : zoomed(shown, whole, view.step_at(place), std::pow(kFactor, turned));
  panel.state.plots.zoom = changed == whole ? std::nullopt : std::optional(changed);
}

/// Returns the parts of the curves in the shown steps.
RunCurves shown_part(const Panel& panel, const RunCurves& curves) {
  return panel.state.plots.zoom ? part_of(curves, shown_steps(panel)) : curves;
}

/// Returns the height of a strip. Strips share the height of the panel, which scrolls if they do not fit.
float strip_height(const Panel& panel, std::size_t count) {
  const float spacing = ImGui::GetStyle().ItemSpacing.y, strips = static_cast<float>(count);
  const float room = ImGui::GetContentRegionAvail().y - plot_times_height(panel) - strips * spacing;
  return std::max(panel.state.plots.for_picture ? 1 : kMinimumStrip * ui_scale(panel), room / strips);
}

}  // namespace

void draw_plot_panel(Panel& panel) {
  plots_bar(panel);
  const RunCurves curves = shown_part(panel, panel.input.curves);
  const std::vector<PlotStrip> strips = plot_strips(curves);
  if (strips.empty()) return hint(panel, "Select series in the list.");
  ImGui::BeginChild("##strips", {0, 0}, false, ImGuiWindowFlags_NoScrollWithMouse);
  const float height = strip_height(panel, strips.size());
  const RunCurves compared_curves =
      panel.input.comparison ? shown_part(panel, panel.input.comparison->curves) : RunCurves();
  const std::vector<PlotStrip> compared = plot_strips(compared_curves);
  for (std::size_t i = 0; i < strips.size(); ++i) {
    const PlotStrip* other = i < compared.size() ? &compared[i] : nullptr;
    const PlotView view = draw_plot_strip(panel, "plots/strip/" + std::to_string(i), strips[i], other, height);
    follow_wheel(panel, view);
    follow_mouse(panel, view);
  }
  draw_plot_times(panel);
  ImGui::EndChild();
  tag_last_item(panel.tags, "plots/strips");
}

}  // namespace griffith::ui
