#include "ui/number_slider.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "ui/style.h"
#include "ui/units.h"

namespace griffith::ui {
namespace {

void begin_typing(EditorState& state, const NumberField& field, double value) {
  state.typed_tag = field.tag;
  state.typed_factor = si_prefix(value, field.unit).factor;
  state.typed_frames = 0;
  std::snprintf(state.typed_text.data(), state.typed_text.size(), "%s", format_quantity(value, field.unit, 6).c_str());
}

/// The text box that stands in the slider's place while a value is typed.
Edit typed_entry(Panel& panel, const NumberField& field, const std::string& item, double& value) {
  EditorState& state = panel.state;
  if (state.typed_frames++ == 0) ImGui::SetKeyboardFocusHere();
  const bool entered = ImGui::InputText(item.c_str(), state.typed_text.data(), state.typed_text.size(),
                                        ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
  // The focus arrives a frame late; without it later on, something else took it before the first key.
  const bool unfocused = state.typed_frames > 3 && !ImGui::IsItemActive();
  const bool left = entered || unfocused || ImGui::IsItemDeactivated();
  tag_last_item(panel.tags, field.tag, state.typed_text.data());
  Edit edit;
  if (!left) return edit;
  state.typed_tag.clear();
  const bool escaped = ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape), false);
  const auto parsed = parse_quantity(state.typed_text.data(), field.unit, state.typed_factor);
  if (escaped || !parsed) return edit;
  const double wanted = std::clamp(*parsed, field.minimum, field.maximum);
  edit.changed = edit.finished = wanted != value;
  value = wanted;
  return edit;
}

/// Paints how full the slider is, behind its text.
void draw_level(const NumberField& field, double value) {
  const double t = field.logarithmic ? std::log(value / field.minimum) / std::log(field.maximum / field.minimum)
                                     : (value - field.minimum) / (field.maximum - field.minimum);
  const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
  const float x = low.x + static_cast<float>(std::clamp(t, 0.0, 1.0)) * (high.x - low.x);
  const float height = std::max(2.0f, 0.1f * (high.y - low.y));
  ImGui::GetWindowDrawList()->AddRectFilled({low.x, high.y - height}, {x, high.y}, palette::kAccent,
                                            ImGui::GetStyle().FrameRounding, ImDrawFlags_RoundCornersBottom);
}

/// What follows from a drag that leads to `wanted`; typing begins where that is asked for.
Edit take_dragged(Panel& panel, const NumberField& field, double wanted, double& value) {
  Edit edit;
  edit.finished = ImGui::IsItemDeactivatedAfterEdit();
  const bool wants_typing =
      ImGui::IsItemHovered() && (ImGui::IsMouseClicked(1) || (ImGui::GetIO().KeyCtrl && ImGui::IsMouseClicked(0)));
  if (wants_typing) {
    begin_typing(panel.state, field, value);
    return edit;
  }
  wanted = std::clamp(wanted, field.minimum, field.maximum);
  edit.changed = wanted != value;
  if (edit.changed) value = wanted;
  return edit;
}

Edit dragged_slider(Panel& panel, const NumberField& field, const std::string& item, double& value) {
  const std::string text = format_quantity(value, field.unit);
  const ImGuiSliderFlags flags =
      ImGuiSliderFlags_NoInput | ImGuiSliderFlags_NoRoundToFormat |
      (field.logarithmic ? static_cast<ImGuiSliderFlags>(ImGuiSliderFlags_Logarithmic) : ImGuiSliderFlags_None);
  double wanted = value;
  ImGui::PushStyleColor(ImGuiCol_SliderGrab, IM_COL32_BLACK_TRANS);
  ImGui::PushStyleColor(ImGuiCol_SliderGrabActive, IM_COL32_BLACK_TRANS);
  ImGui::SliderScalar(item.c_str(), ImGuiDataType_Double, &wanted, &field.minimum, &field.maximum, text.c_str(), flags);
  ImGui::PopStyleColor(2);
  tag_last_item(panel.tags, field.tag, text);
  draw_level(field, value);
  return take_dragged(panel, field, wanted, value);
}

Edit free_drag(Panel& panel, const NumberField& field, const std::string& item, double& value) {
  constexpr double kSharePerPixel = 0.005, kLeast = 0.1;
  const std::string text = format_quantity(value, field.hide_unit ? "" : field.unit, 4);
  const double least = field.minimum > 0 ? field.minimum : std::min(kLeast, field.maximum);
  const float speed = static_cast<float>(kSharePerPixel * std::max(std::abs(value), least));
  double wanted = value;
  ImGui::DragScalar(item.c_str(), ImGuiDataType_Double, &wanted, speed, nullptr, nullptr, text.c_str(),
                    ImGuiSliderFlags_NoInput | ImGuiSliderFlags_NoRoundToFormat);
  tag_last_item(panel.tags, field.tag, text);
  return take_dragged(panel, field, wanted, value);
}

}  // namespace

Edit number_slider(Panel& panel, const NumberField& field, double& value) {
  row_label(panel, field.label);
  const std::string item = "##" + std::string(field.tag);
  const bool typing = panel.state.typed_tag == field.tag;
  const Edit edit =
      typing ? typed_entry(panel, field, item + "_text", value) : dragged_slider(panel, field, item, value);
  if (!typing) tooltip(field.tooltip);
  return edit;
}

Edit number_drag(Panel& panel, const NumberField& field, double& value) {
  const std::string item = "##" + std::string(field.tag);
  const bool typing = panel.state.typed_tag == field.tag;
  const Edit edit = typing ? typed_entry(panel, field, item + "_text", value) : free_drag(panel, field, item, value);
  if (!typing) tooltip(field.tooltip);
  return edit;
}

}  // namespace griffith::ui
