#include <cstdio>

#include "ui/panels.h"
#include "ui/style.h"
#include "ui/widgets.h"

namespace griffith::ui {
namespace {

/// Pieces that the scene's body is in by now.
int piece_count(const Frame& frame, int scene_body) {
  int count = 0;
  for (const BodyView& body : frame.bodies) count += body.scene_body == scene_body && body.tets > 0;
  return count;
}

void body_row(Panel& panel, int index, const BodyDescription& body) {
  const int pieces = piece_count(panel.input.frame, index);
  const std::string item = body.name + "##body" + std::to_string(index);
  if (ImGui::Selectable(item.c_str(), panel.state.selected_body == index)) {
    panel.state.selected_body = index;
    panel.state.selection = {};
  }
  tag_last_item(panel.tags, "bodies/" + std::to_string(index), body.name);
  char text[64];
  std::snprintf(text, sizeof text, pieces == 1 ? "%s" : "%s, %d pieces", body.material.name.c_str(), pieces);
  ImGui::SameLine(ImGui::GetWindowContentRegionMax().x - ImGui::CalcTextSize(text).x);
  ImGui::TextColored(as_vec4(pieces > 1 ? palette::kAccent : palette::kTextDim), "%s", text);
}

}  // namespace

void draw_bodies_panel(Panel& panel) {
  heading(panel, "Bodies");
  const std::vector<BodyDescription>& bodies = panel.history.scene().bodies;
  if (bodies.empty()) hint(panel, "The scene has no bodies. Open one with File > Open, or drop a scene file here.");
  const int shown = std::min(static_cast<int>(bodies.size()), 8);
  const float height = static_cast<float>(shown) * ImGui::GetTextLineHeightWithSpacing();
  if (shown == 0) return;
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {8 * ui_scale(panel), 2 * ui_scale(panel)});
  ImGui::BeginChild("##bodies", {0, height + 4 * ui_scale(panel)}, false, ImGuiWindowFlags_AlwaysUseWindowPadding);
  ImGui::PopStyleVar();
  for (std::size_t i = 0; i < bodies.size(); ++i) body_row(panel, static_cast<int>(i), bodies[i]);
  ImGui::EndChild();
}

}  // namespace griffith::ui
