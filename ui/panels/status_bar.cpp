#include "ui/model/status_line.h"
#include "ui/panels/panels.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace griffith::ui {
namespace {

constexpr int kLinesInTooltip = 12;
constexpr char kRecording[] = "recording a macro";

void recent_lines(const std::vector<LogLine>& log) {
  const ImVec2 corner = ImGui::GetWindowPos();
  ImGui::SetNextWindowPos({corner.x + ImGui::GetStyle().WindowPadding.x, corner.y}, ImGuiCond_Always, {0, 1});
  ImGui::BeginTooltip();
  const auto count = std::min<std::ptrdiff_t>(kLinesInTooltip, static_cast<std::ptrdiff_t>(log.size()));
  for (auto line = log.end() - count; line != log.end(); ++line) {
    ImGui::TextColored(as_vec4(level_color(line->level)), "%s", line->text.c_str());
  }
  ImGui::EndTooltip();
}

/// Draws the number of problems as a button, if there are any.
void problem_count(Panel& panel, float place) {
  const std::string text = problem_count_text(panel.input.problems);
  ImGui::SameLine(place);
  ImGui::TextColored(as_vec4(palette::kWarning), "%s", text.c_str());
  tag_last_item(panel.tags, "status/problems", text);
  if (ImGui::IsItemClicked()) issue(panel, {.name = "view.problems"});
  tooltip(panel.input.problems.front().text);
}

/// Shows that a macro is being recorded; a click stops it.
void recording_mark(Panel& panel, float place) {
  ImGui::SameLine(place);
  ImGui::TextColored(as_vec4(palette::kError), "%s", kRecording);
  tag_last_item(panel.tags, "status/recording", kRecording);
  if (ImGui::IsItemClicked()) issue(panel, {.name = "edit.record_macro"});
  tooltip("Click to stop recording and enter a name.");
}

}  // namespace

void draw_status_bar(Panel& panel) {
  const std::vector<LogLine>& log = panel.state.log;
  ImGui::PushFont(panel.input.fonts.small);
  const std::string text = panel.input.scene_path.empty() ? "not saved" : panel.input.scene_path.filename().string();
  const float gap = 2 * ImGui::GetStyle().ItemSpacing.x;
  const float file = ImGui::GetWindowWidth() - ImGui::GetStyle().WindowPadding.x - ImGui::CalcTextSize(text.c_str()).x;
  const bool any_problem = !panel.input.problems.empty(), records = panel.state.recording_macro;
  const float problems =
      any_problem ? file - gap - ImGui::CalcTextSize(problem_count_text(panel.input.problems).c_str()).x : file;
  const float place = records ? problems - gap - ImGui::CalcTextSize(kRecording).x : problems;
  if (!panel.state.work.empty()) {
    const std::string work = panel.state.work + " ...";
    ImGui::TextUnformatted(work.c_str());
    tag_last_item(panel.tags, "status/work", work);
  } else if (const LogLine* last = status_line(panel.state)) {
    const bool is_new = panel.state.log_seen <= static_cast<std::size_t>(last - log.data());
    const LogLevel level = is_new ? last->level : LogLevel::info;
    const float room = place - ImGui::GetCursorPosX() - ImGui::GetStyle().ItemSpacing.x;
    ImGui::TextColored(as_vec4(level_color(level)), "%s", fitted(last->text, room).c_str());
    tag_last_item(panel.tags, "status/message", last->text);
    panel.tags.back().color = level_color(level);
    if (ImGui::IsItemHovered()) recent_lines(log);
  }
  if (records) recording_mark(panel, place);
  if (any_problem) problem_count(panel, problems);
  ImGui::SameLine(file);
  ImGui::TextColored(as_vec4(palette::kTextDim), "%s", text.c_str());
  tag_last_item(panel.tags, "status/file", text);
  if (!panel.input.scene_path.empty() && ImGui::IsItemHovered())
    ImGui::SetTooltip("%s", panel.input.scene_path.c_str());
  ImGui::PopFont();
}

}  // namespace griffith::ui
