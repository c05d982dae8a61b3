#include <algorithm>
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

constexpr float kListWidth = 200, kMinimumStrip = 56;  // design pixels

/// An entry of the list, in the colour of its curve where it is plotted.
void series_entry(Panel& panel, const RunSeries& series) {
  PlotChoice& chosen = panel.state.plots.chosen;
  const auto slot = std::ranges::find(chosen, series.key);
  const bool plotted = slot != chosen.end();
  if (plotted) ImGui::PushStyleColor(ImGuiCol_Text, plot_color(static_cast<std::size_t>(slot - chosen.begin())));
  ImGui::BeginDisabled(!plotted && count_series(chosen) == kMaxPlotted);
  const std::string label = series.label + "###" + series.key;
  if (ImGui::Selectable(label.c_str(), plotted, ImGuiSelectableFlags_DontClosePopups))
    toggle_series(chosen, series.key);
  ImGui::EndDisabled();
  if (plotted) ImGui::PopStyleColor();
  tag_last_item(panel.tags, "plots/series/" + series.key, plotted ? "on" : "off");
}

void series_list(Panel& panel) {
  ImGui::SetNextItemWidth(kListWidth * ui_scale(panel));
  const std::string shown =
      std::to_string(count_series(panel.state.plots.chosen)) + " of at most " + std::to_string(kMaxPlotted) + " series";
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

/// What is plotted, and what can be done with it.
void plots_bar(Panel& panel) {
  series_list(panel);
  ImGui::SameLine();
  ImGui::BeginDisabled(!command_enabled(CommandId::save_plots_dialog, panel));
  if (text_button(panel, "plots/save", "Save CSV…")) issue(panel, {.id = CommandId::save_plots_dialog});
  ImGui::EndDisabled();
  ImGui::SameLine();
  if (text_button(panel, "plots/close", "Close")) issue(panel, {.id = CommandId::toggle_plots});
}

/// Which of the recorded steps it is; nothing where it is none.
std::optional<std::size_t> row_of(const RunCurves& curves, std::int64_t step) {
  const auto row = std::ranges::lower_bound(curves.steps, step);
  if (row == curves.steps.end() || *row != step) return std::nullopt;
  return static_cast<std::size_t>(row - curves.steps.begin());
}

/// The value of a curve at a step, and that of the compared branch behind it.
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

/// The values of all curves at a step, beside the mouse.
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

/// Of the strip drawn last: a click or a drag goes to a step.
void follow_mouse(Panel& panel, const PlotView& view) {
  const bool held = ImGui::IsItemActive();
  if (!held && !ImGui::IsItemHovered()) return;
  const std::int64_t pointed = view.step_at(static_cast<double>(ImGui::GetIO().MousePos.x));
  if (held && pointed != panel.input.frame.step) issue(panel, {.id = CommandId::go_to_step, .step = pointed});
  values_tooltip(panel, pointed);
}

/// Strips share the height of the panel, and scroll where that is too little.
float strip_height(const Panel& panel, std::size_t count) {
  const float spacing = ImGui::GetStyle().ItemSpacing.y, strips = static_cast<float>(count);
  const float room = ImGui::GetContentRegionAvail().y - plot_times_height(panel) - strips * spacing;
  return std::max(kMinimumStrip * ui_scale(panel), room / strips);
}

}  // namespace

void draw_plot_panel(Panel& panel) {
  plots_bar(panel);
  const std::vector<PlotStrip> strips = plot_strips(panel.input.curves);
  if (strips.empty()) return hint(panel, "Choose in the list what is to be plotted.");
  ImGui::BeginChild("##strips");
  const float height = strip_height(panel, strips.size());
  std::vector<PlotStrip> compared;
  if (panel.input.comparison) compared = plot_strips(panel.input.comparison->curves);
  for (std::size_t i = 0; i < strips.size(); ++i) {
    const PlotStrip* other = i < compared.size() ? &compared[i] : nullptr;
    follow_mouse(panel, draw_plot_strip(panel, "plots/strip/" + std::to_string(i), strips[i], other, height));
  }
  draw_plot_times(panel);
  ImGui::EndChild();
}

}  // namespace griffith::ui
