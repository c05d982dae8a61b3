#include "ui/panels.h"
#include "ui/style.h"
#include "ui/widgets.h"

namespace griffith::ui {
namespace {

constexpr int kLinesInTooltip = 12;

ImU32 level_color(LogLevel level) {
  switch (level) {
    case LogLevel::info:
      return palette::kTextDim;
    case LogLevel::warning:
      return palette::kWarning;
    case LogLevel::error:
      return palette::kError;
  }
  return palette::kText;
}

void recent_lines(const std::vector<LogLine>& log) {
  ImGui::BeginTooltip();
  const auto count = std::min<std::ptrdiff_t>(kLinesInTooltip, static_cast<std::ptrdiff_t>(log.size()));
  for (auto line = log.end() - count; line != log.end(); ++line) {
    ImGui::TextColored(as_vec4(level_color(line->level)), "%s", line->text.c_str());
  }
  ImGui::EndTooltip();
}

}  // namespace

void draw_status_bar(Panel& panel) {
  const std::vector<LogLine>& log = panel.state.log;
  ImGui::PushFont(panel.input.fonts.small);
  if (!log.empty()) {
    ImGui::TextColored(as_vec4(level_color(log.back().level)), "%s", log.back().text.c_str());
    tag_last_item(panel.tags, "status/message", log.back().text);
    if (ImGui::IsItemHovered()) recent_lines(log);
  }
  const std::string text = panel.input.scene_path.empty() ? "not saved" : panel.input.scene_path.string();
  ImGui::SameLine(ImGui::GetWindowWidth() - ImGui::GetStyle().WindowPadding.x - ImGui::CalcTextSize(text.c_str()).x);
  ImGui::TextColored(as_vec4(palette::kTextDim), "%s", text.c_str());
  ImGui::PopFont();
}

}  // namespace griffith::ui
