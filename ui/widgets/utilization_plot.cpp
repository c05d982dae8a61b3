#include "ui/widgets/utilization_plot.h"

#include <algorithm>
#include <cmath>

#include "ui/model/units.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace griffith::ui {
namespace {

ImU32 utilization_color(double utilization) {
  return utilization > 1 ? palette::kError : utilization > 0.8 ? palette::kWarning : palette::kGood;
}

/// Adds a tagged field as wide as the panel. Returns its corners.
std::pair<ImVec2, ImVec2> field(Panel& panel, const char* tag, float design_height, const std::string& value) {
  const float width = ImGui::GetContentRegionAvail().x, height = design_height * ui_scale(panel);
  ImGui::Dummy({width, height});
  tag_last_item(panel.tags, tag, value);
  const ImVec2 low = ImGui::GetItemRectMin(), high = {low.x + width, low.y + height};
  ImGui::GetWindowDrawList()->AddRectFilled(low, high, palette::kField, 3 * ui_scale(panel));
  return {low, high};
}

}  // namespace

void draw_utilization_bar(Panel& panel, double utilization) {
  const auto [low, high] = field(panel, "inspector/utilization_bar", 14, format_quantity(utilization, "", 3));
  const double top = std::max(1.0, std::isfinite(utilization) ? utilization : 0.0);
  const float fraction = static_cast<float>(std::clamp(utilization, 0.0, top) / top), width = high.x - low.x;
  ImDrawList* list = ImGui::GetWindowDrawList();
  list->AddRectFilled(low, {low.x + fraction * width, high.y}, utilization_color(utilization), 3 * ui_scale(panel));
  const float limit = low.x + width / static_cast<float>(top) - ui_scale(panel);
  list->AddLine({limit, low.y}, {limit, high.y}, palette::kText, 2 * ui_scale(panel));
}

void draw_utilization_plot(Panel& panel, std::span<const UtilizationSample> samples) {
  if (samples.size() < 2) return;
  const auto [low, high] = field(panel, "inspector/utilization_plot", 64, std::to_string(samples.size()));
  const float largest = std::ranges::max(samples, {}, &UtilizationSample::utilization).utilization;
  const double top = 1.4 * std::max(1.0f, std::isfinite(largest) ? largest : 1.0f);
  const double start = samples.front().time, length = std::max(samples.back().time - start, 1e-9);
  const auto place = [&, l = low, h = high](double time, double utilization) {
    return ImVec2(l.x + static_cast<float>((time - start) / length) * (h.x - l.x),
                  h.y - static_cast<float>(std::clamp(utilization / top, 0.0, 1.0)) * (h.y - l.y));
  };
  ImDrawList* list = ImGui::GetWindowDrawList();
  const float scale = ui_scale(panel);
  list->AddLine(place(start, 1), place(start + length, 1), palette::kTextDim, scale);
  std::vector<ImVec2> line;
  for (const UtilizationSample& sample : samples) line.push_back(place(sample.time, sample.utilization));
  list->AddPolyline(line.data(), static_cast<int>(line.size()), palette::kAccent, 0, 1.5f * scale);
  for (const UtilizationSample& sample : samples)
    if (sample.broke) list->AddCircleFilled(place(sample.time, sample.utilization), 3.5f * scale, palette::kError);
  const std::string span =
      "utilization, " + format_quantity(start, "s", 3) + " to " + format_quantity(start + length, "s", 3);
  const Fonts& fonts = panel.input.fonts;
  list->AddText(fonts.small, fonts.small->FontSize, {low.x + 5 * scale, low.y + 2 * scale}, palette::kTextDim,
                span.c_str());
}

}  // namespace griffith::ui
