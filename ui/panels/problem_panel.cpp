#include "ui/model/entry_choice.h"
#include "ui/panels/panels.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace griffith::ui {
namespace {

/// Frames in which panels unfold the field, find its position and scroll there.
constexpr int kFramesToSeek = 4;

/// Selects the entry of the problem, and shows its field with the problem next to it.
void go_to_field(Panel& panel, const SceneProblem& problem) {
  const FieldPlace place = field_place(panel.history.scene(), problem.pointer);
  if (place.entry) select_entries(panel.state, panel.history.scene(), {*place.entry});
  panel.state.sought = {place.tag, kFramesToSeek};
  panel.state.field_note = {place.tag, problem.text + (problem.remedy.empty() ? "" : ": " + problem.remedy) + "."};
}

void problem_row(Panel& panel, const SceneProblem& problem, const std::string& tag) {
  const std::string place = place_text(panel.history.scene(), problem.pointer);
  const ImVec2 corner = ImGui::GetCursorPos();
  const float width = ImGui::GetContentRegionAvail().x;
  const std::string text = problem.text + (problem.remedy.empty() ? "" : " (" + problem.remedy + ")");
  const float place_width = 0.36f * width;
  const float height = ImGui::CalcTextSize(text.c_str(), nullptr, false, width - place_width).y;
  if (ImGui::Selectable(("##" + tag).c_str(), false, 0, {0, height})) go_to_field(panel, problem);
  tag_last_item(panel.tags, tag, place + ": " + text);
  const ImVec2 next = ImGui::GetCursorPos();
  ImGui::SetCursorPos(corner);
  ImGui::TextUnformatted(fitted(place, place_width - 2 * ImGui::GetStyle().ItemSpacing.x).c_str());
  ImGui::SetCursorPos({corner.x + place_width, corner.y});
  wrapped_text(text, palette::kWarning);
  ImGui::SetCursorPos(next);
}

}  // namespace

std::string problem_count_text(std::span<const SceneProblem> problems) {
  if (problems.empty()) return "no problems";
  return std::to_string(problems.size()) + (problems.size() == 1 ? " problem" : " problems");
}

void draw_problem_panel(Panel& panel) {
  const std::span<const SceneProblem> problems = panel.input.problems;
  if (text_button(panel, "problems/close", "Close")) panel.state.problem_view.shown = false;
  ImGui::SameLine();
  ImGui::AlignTextToFramePadding();
  ImGui::TextColored(as_vec4(palette::kTextDim), "%s: click to go to the field", problem_count_text(problems).c_str());
  tag_last_item(panel.tags, "problems/count", problem_count_text(problems));
  ImGui::Separator();
  ImGui::BeginChild("##list");
  for (std::size_t i = 0; i < problems.size(); ++i) problem_row(panel, problems[i], "problems/" + std::to_string(i));
  ImGui::EndChild();
}

}  // namespace griffith::ui
