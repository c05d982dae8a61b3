#include "ui/widgets/number_slider.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "ui/widgets/style.h"

namespace griffith::ui {
namespace {

void begin_typing(EditorState& state, const NumberField& field, double value) {
  state.typed_tag = field.tag;
  state.typed_frames = 0;
  std::snprintf(state.typed_text.data(), state.typed_text.size(), "%s",
                format_quantity(value, unit_symbol(field.numbers), 6).c_str());
}

std::string nonsense_note(const std::string& text, const Numbers& numbers) {
  const std::string unit(unit_symbol(numbers));
  return "\"" + text + "\" is not a number" + (unit.empty() ? "" : " of " + unit) + ". " +
         range_text_with_prefix(numbers) + " is possible.";
}

/// What the text would be taken for: "= 100 mm".
std::string meaning(const std::string& text, const Numbers& numbers) {
  const auto parsed = parse_quantity(text, unit_symbol(numbers));
  if (!parsed) return nonsense_note(text, numbers);
  const double taken = std::clamp(*parsed, numbers.minimum, numbers.maximum);
  const std::string shown = "= " + format_quantity(taken, unit_symbol(numbers), 6);
  return taken == *parsed ? shown : shown + ": " + range_text_with_prefix(numbers) + " is possible.";
}

/// Takes what was typed; what it was not taken for is noted.
Edit take_typed(EditorState& state, const NumberField& field, double& value) {
  const std::string text = state.typed_text.data();
  const auto parsed = parse_quantity(text, unit_symbol(field.numbers));
  if (!parsed) {
    state.field_note = {field.tag, nonsense_note(text, field.numbers) + " The value stays."};
    return {};
  }
  const double wanted = std::clamp(*parsed, field.numbers.minimum, field.numbers.maximum);
  if (wanted != *parsed) state.field_note = {field.tag, clamped_note(*parsed, field.numbers)};
  const bool changed = wanted != value;
  value = wanted;
  return {changed, changed};
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
  if (!left) {
    const std::string text = meaning(state.typed_text.data(), field.numbers);
    draw_bubble(text, palette::kAccent);
    tag_last_item(panel.tags, "typed_meaning", text);
    return {};
  }
  state.typed_tag.clear();
  return ImGui::IsKeyPressed(key::kEscape, false) ? Edit{} : take_typed(state, field, value);
}

/// Paints how full the slider is, behind its text.
void draw_level(const NumberField& field, double value) {
  const double inside = std::clamp(value, field.low, field.high);
  const double t = field.logarithmic ? std::log(inside / field.low) / std::log(field.high / field.low)
                                     : (inside - field.low) / (field.high - field.low);
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
  wanted = std::clamp(wanted, field.numbers.minimum, field.numbers.maximum);
  edit.changed = wanted != value;
  if (edit.changed) value = wanted;
  return edit;
}

Edit dragged_slider(Panel& panel, const NumberField& field, const std::string& item, double& value) {
  const std::string text = format_quantity(value, unit_symbol(field.numbers));
  const ImGuiSliderFlags flags =
      ImGuiSliderFlags_NoInput | ImGuiSliderFlags_NoRoundToFormat |
      (field.logarithmic ? static_cast<ImGuiSliderFlags>(ImGuiSliderFlags_Logarithmic) : ImGuiSliderFlags_None);
  double wanted = value;
  ImGui::PushStyleColor(ImGuiCol_SliderGrab, IM_COL32_BLACK_TRANS);
  ImGui::PushStyleColor(ImGuiCol_SliderGrabActive, IM_COL32_BLACK_TRANS);
  ImGui::SliderScalar(item.c_str(), ImGuiDataType_Double, &wanted, &field.low, &field.high, text.c_str(), flags);
  ImGui::PopStyleColor(2);
  tag_last_item(panel.tags, field.tag, text);
  draw_level(field, value);
  return take_dragged(panel, field, wanted, value);
}

/// Text of the number with as many digits as there is room for.
std::string shown_number(const NumberField& field, double value) {
  if (!field.prefix) return format_quantity(value, unit_symbol(field.numbers));
  const float room = ImGui::CalcItemWidth() - 2 * ImGui::GetStyle().FramePadding.x;
  for (int digits = 5; digits > 1; --digits) {
    const std::string text = format_number(value, *field.prefix, digits);
    if (ImGui::CalcTextSize(text.c_str()).x <= room) return text;
  }
  return fitted(format_number(value, *field.prefix, 1), room);
}

Edit free_drag(Panel& panel, const NumberField& field, const std::string& item, double& value) {
  constexpr double kSharePerPixel = 0.005, kMinimum = 0.1;
  const std::string text = shown_number(field, value);
  const double minimum = field.numbers.minimum > 0 ? field.numbers.minimum : std::min(kMinimum, field.numbers.maximum);
  const float speed = static_cast<float>(kSharePerPixel * std::max(std::abs(value), minimum));
  double wanted = value;
  ImGui::DragScalar(item.c_str(), ImGuiDataType_Double, &wanted, speed, nullptr, nullptr, text.c_str(),
                    ImGuiSliderFlags_NoInput | ImGuiSliderFlags_NoRoundToFormat);
  tag_last_item(panel.tags, field.tag, text);
  return take_dragged(panel, field, wanted, value);
}

Edit typed_or(Panel& panel, const NumberField& field, double& value,
              Edit (*dragged)(Panel&, const NumberField&, const std::string&, double&)) {
  const std::string item = "##" + field.tag;
  if (panel.state.typed_tag == field.tag) return typed_entry(panel, field, item + "_text", value);
  const Edit edit = dragged(panel, field, item, value);
  field_tooltip(panel, field.tag, field.tooltip);
  return edit;
}

/// Tells at the label what the value was; whether it is to be that again.
bool offers_original(const NumberField& field) {
  if (!ImGui::IsItemHovered()) return false;
  const std::string original = format_quantity(*field.original, unit_symbol(field.numbers));
  ImGui::SetTooltip("Was %s. Click to take it back to that.", original.c_str());
  return ImGui::IsMouseClicked(ImGuiMouseButton_Left);
}

}  // namespace

Edit number_slider(Panel& panel, const NumberField& field, double& value) {
  const bool is_edited = field.original && *field.original != value;
  row_label(panel, field.label.c_str(), is_edited ? palette::kAccent : palette::kTextDim);
  const bool is_reset = is_edited && offers_original(field);
  if (is_reset) value = *field.original;
  const Edit edit = typed_or(panel, field, value, dragged_slider);
  return is_reset ? Edit{true, true} : edit;
}

Edit number_drag(Panel& panel, const NumberField& field, double& value) {
  return typed_or(panel, field, value, free_drag);
}

}  // namespace griffith::ui
