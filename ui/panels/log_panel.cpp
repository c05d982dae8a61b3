#include <algorithm>
#include <array>
#include <cfloat>
#include <string_view>

#include "ui/panels/panels.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace griffith::ui {
namespace {

constexpr std::array kLevelNames = {"info", "warnings", "errors"};

bool is_shown(const LogLine& line, const LogView& view) {
  return view.levels[static_cast<std::size_t>(line.level)] && line.text.find(view.filter.data()) != std::string::npos;
}

void copy_lines(std::span<const LogLine* const> lines) {
  std::string text;
  for (const LogLine* line : lines) text += line->text + "\n";
  ImGui::SetClipboardText(text.c_str());
}

/// Draws the levels with their numbers of lines, the filter, and the buttons for lines.
void log_bar(Panel& panel, std::span<const LogLine* const> lines) {
  LogView& view = panel.state.log_view;
  std::vector<LogLine>& log = panel.state.log;
  for (std::size_t level = 0; level < kLevelNames.size(); ++level) {
    const auto count = std::ranges::count(log, static_cast<LogLevel>(level), &LogLine::level);
    const std::string name = kLevelNames[level], label = name + " (" + std::to_string(count) + ")###" + name;
    checkbox(panel, ("log/" + name).c_str(), label.c_str(), view.levels[level]);
    ImGui::SameLine();
  }
  if (text_button(panel, "log/copy", "Copy")) copy_lines(lines);
  ImGui::SameLine();
  if (text_button(panel, "log/clear", "Clear")) {
    log.clear();
    panel.state.log_seen = panel.state.log_passed = 0;
  }
  ImGui::SameLine();
  if (text_button(panel, "log/close", "Close")) view.shown = false;
  ImGui::SameLine();
  ImGui::SetNextItemWidth(-FLT_MIN);
  ImGui::InputTextWithHint("##filter", "text of lines", view.filter.data(), view.filter.size());
  tag_last_item(panel.tags, "log/filter", view.filter.data());
}

/// Draws the lines; follows the newest one until the user scrolls up.
void log_lines(Panel& panel, std::span<const LogLine* const> lines) {
  ImGui::BeginChild("##lines");
  for (const LogLine* line : lines) {
    wrapped_text(line->text, level_color(line->level));
    tag_last_item(panel.tags, "log/line", line->text);
  }
  if (ImGui::GetScrollY() >= ImGui::GetScrollMaxY()) ImGui::SetScrollHereY(1);
  ImGui::EndChild();
}

std::vector<const LogLine*> shown_lines(const EditorState& state) {
  std::vector<const LogLine*> lines;
  for (const LogLine& line : state.log)
    if (is_shown(line, state.log_view)) lines.push_back(&line);
  return lines;
}

}  // namespace

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

void draw_log_panel(Panel& panel) {
  log_bar(panel, shown_lines(panel.state));
  ImGui::Separator();
  log_lines(panel, shown_lines(panel.state));
}

}  // namespace griffith::ui
