#include <algorithm>

#include "ui/panels/panels.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace griffith::ui {
namespace {

constexpr float kCaptionWidth = 380, kRoomDown = 260;  // design pixels
constexpr ImGuiWindowFlags kCaptionFlags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                           ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_AlwaysAutoResize |
                                           ImGuiWindowFlags_NoFocusOnAppearing;

/// Frames the widget to which the caption refers.
void mark(const Panel& panel, const WidgetTag& widget) {
  const float scale = ui_scale(panel), gap = 3 * scale;
  ImGui::GetForegroundDrawList()->AddRect({widget.minimum.x - gap, widget.minimum.y - gap},
                                          {widget.maximum.x + gap, widget.maximum.y + gap}, palette::kAccent, 4 * scale,
                                          0, 2 * scale);
}

/// Places the caption in the middle of the view, low enough to keep the action visible; at the top of a low view.
void place_caption(const Panel& panel) {
  const EditorState& state = panel.state;
  const float margin = 48 * ui_scale(panel);
  const float width = std::min(kCaptionWidth * ui_scale(panel), state.viewport_size.x - margin);
  const bool is_low = state.viewport_size.y < kRoomDown * ui_scale(panel);
  const float x = state.viewport_minimum.x + state.viewport_size.x / 2;
  const float y = state.viewport_minimum.y + (is_low ? 0 : state.viewport_size.y - margin);
  ImGui::SetNextWindowPos({x, y}, ImGuiCond_Always, {0.5f, is_low ? 0.0f : 1.0f});
  ImGui::SetNextWindowSizeConstraints({width, 0}, {width, FLT_MAX});
}

}  // namespace

void draw_caption(Panel& panel) {
  std::optional<Caption>& caption = panel.state.caption;
  if (!caption) return;
  if (const WidgetTag* widget = find_tag(panel.tags, caption->tag)) mark(panel, *widget);
  place_caption(panel);
  ImGui::PushStyleColor(ImGuiCol_Border, palette::kAccent);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, ui_scale(panel));
  ImGui::Begin("##caption", nullptr, kCaptionFlags);
  ImGui::PopStyleVar();
  ImGui::PopStyleColor();
  wrapped_text(caption->text);
  tag_last_item(panel.tags, "caption/text", caption->text);
  ImGui::Spacing();
  const float width = 90 * ui_scale(panel);
  if (text_button(panel, "caption/next", "Next", width)) caption->answer = Caption::Answer::next;
  ImGui::SameLine();
  if (text_button(panel, "caption/skip", "Skip", width)) caption->answer = Caption::Answer::skip;
  ImGui::End();
}

}  // namespace griffith::ui
