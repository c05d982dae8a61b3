#include "ui/widgets/number_field.h"

#include <imgui_stdlib.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "ui/widgets/style.h"

namespace griffith::ui {
namespace {

/// Relative change by a pixel of a drag [-].
constexpr double kSharePerPixel = 0.005;
/// A mouse that has moved less since it was pressed has clicked [design pixels].
constexpr float kClickReach = 3;
/// Digits of a number that is shown, and of one that is typed over.
constexpr int kShownDigits = 4, kTypedDigits = 6;

bool is_entered(const EditorState& state, const NumberField& field) { return state.number_entry.tag == field.tag; }

/// The prefix in which a field shows its number: while it is edited, the one that it began with.
SiPrefix shown_prefix(const EditorState& state, const NumberField& field, double value) {
  if (is_entered(state, field)) return state.number_entry.prefix;
  return field.prefix.value_or(si_prefix(value, unit_symbol(field.numbers)));
}

std::string quantity_text(const NumberField& field, double value, const SiPrefix& prefix, int digits) {
  return format_quantity(value, unit_symbol(field.numbers), prefix, digits);
}

/// Text of the number with as many digits as there is room for.
std::string shown_text(const NumberField& field, double value, const SiPrefix& prefix) {
  if (!field.prefix) return quantity_text(field, value, prefix, kShownDigits);
  const float room = ImGui::CalcItemWidth() - 2 * ImGui::GetStyle().FramePadding.x;
  for (int digits = kShownDigits + 1; digits > 1; --digits) {
    const std::string text = format_number(value, prefix, digits);
    if (ImGui::CalcTextSize(text.c_str()).x <= room) return text;
  }
  return fitted(format_number(value, prefix, 1), room);
}

/// The entry with which an edit of the field begins.
NumberEntry entry_of(const EditorState& state, const NumberField& field, double value) {
  return {.tag = field.tag,
          .prefix = shown_prefix(state, field, value),
          .row_unit = field.prefix ? std::string(unit_symbol(field.numbers)) : "",
          .start = value};
}

void begin_typing(EditorState& state, const NumberField& field, double value) {
  state.number_entry = entry_of(state, field, value);
  state.number_entry.typing = true;
  const SiPrefix& prefix = state.number_entry.prefix;
  state.number_entry.text = quantity_text(field, value, prefix, kTypedDigits);
  state.number_entry.first_text = state.number_entry.text;
}

std::string nonsense_note(const std::string& text, const Numbers& numbers) {
  const std::string unit(unit_symbol(numbers));
  return "\"" + text + "\" is not a number" + (unit.empty() ? "" : " of " + unit) + ". " +
         range_text_with_prefix(numbers) + " is possible.";
}

/// What was typed as a number of the unit without prefix, rounded where only whole ones are taken.
std::optional<double> typed_number(const NumberEntry& entry, const NumberField& field) {
  const auto parsed = parse_quantity(entry.text, unit_symbol(field.numbers), entry.prefix);
  return parsed && field.whole ? std::round(*parsed) : parsed;
}

/// What the text would be taken for: "= 100 mm".
std::string meaning(const NumberEntry& entry, const NumberField& field) {
  const auto typed = typed_number(entry, field);
  if (!typed) return nonsense_note(entry.text, field.numbers);
  const double taken = std::clamp(*typed, field.numbers.minimum, field.numbers.maximum);
  const std::string shown = "= " + format_quantity(taken, unit_symbol(field.numbers), kTypedDigits);
  return taken == *typed ? shown : shown + ": " + range_text_with_prefix(field.numbers) + " is possible.";
}

/// Takes what was typed; what it was not taken for is noted.
Edit take_typed(EditorState& state, const NumberField& field, const NumberEntry& entry, double& value) {
  if (entry.text == entry.first_text) return {};
  const auto typed = typed_number(entry, field);
  if (!typed) {
    state.field_note = {field.tag, nonsense_note(entry.text, field.numbers) + " The value stays."};
    return {};
  }
  const double wanted = std::clamp(*typed, field.numbers.minimum, field.numbers.maximum);
  if (wanted != *typed) state.field_note = {field.tag, clamped_note(*typed, field.numbers)};
  const bool changed = wanted != value;
  value = wanted;
  return {changed, changed};
}

/// Opens the field that is drawn after this one, or before it.
void open_neighbor(EditorState& state, const std::string& tag, int way) {
  const std::vector<std::string>& tags = state.last_number_tags;
  const auto at = std::ranges::find(tags, tag);
  if (at == tags.end()) return;
  const auto count = static_cast<std::ptrdiff_t>(tags.size());
  state.opened_number = tags[static_cast<std::size_t>((at - tags.begin() + way + count) % count)];
}

/// The text box that stands in the field's place while a value is typed.
Edit typed_entry(Panel& panel, const NumberField& field, double& value) {
  NumberEntry& entry = panel.state.number_entry;
  if (entry.frames++ == 0) ImGui::SetKeyboardFocusHere();
  // Dear ImGui leaves Tab to a callback where there is one.
  const auto ignore = [](ImGuiInputTextCallbackData*) { return 0; };
  const bool entered = ImGui::InputText(
      ("##" + field.tag + "_text").c_str(), &entry.text,
      ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll | ImGuiInputTextFlags_CallbackCompletion,
      ignore);
  // The focus arrives a frame late; without it later on, something else took it before the first key.
  const bool unfocused = entry.frames > 3 && !ImGui::IsItemActive();
  const bool tabbed = ImGui::IsItemActive() && ImGui::IsKeyPressed(key::kTab, false);
  const bool left = entered || unfocused || tabbed || ImGui::IsItemDeactivated();
  tag_last_item(panel.tags, field.tag, entry.text);
  if (!left) {
    const std::string text = meaning(entry, field);
    draw_bubble(text, palette::kAccent);
    tag_last_item(panel.tags, "typed_meaning", text);
    return {};
  }
  const NumberEntry typed = std::exchange(entry, {});
  if (tabbed) open_neighbor(panel.state, field.tag, ImGui::GetIO().KeyShift ? -1 : 1);
  return ImGui::IsKeyPressed(key::kEscape, false) ? Edit{} : take_typed(panel.state, field, typed, value);
}

/// Paints the field, and how high its value is where it has ends.
void draw_box(const Panel& panel, const NumberField& field, double value, const std::string& text) {
  const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
  const ImGuiStyle& style = ImGui::GetStyle();
  ImDrawList* list = ImGui::GetWindowDrawList();
  const ImGuiCol color = ImGui::IsItemActive()    ? ImGuiCol_FrameBgActive
                         : ImGui::IsItemHovered() ? ImGuiCol_FrameBgHovered
                                                  : ImGuiCol_FrameBg;
  list->AddRectFilled(low, high, ImGui::GetColorU32(color), style.FrameRounding);
  const double inside = std::clamp(value, field.low, field.high);
  const double t = field.logarithmic ? std::log(inside / field.low) / std::log(field.high / field.low)
                                     : (inside - field.low) / (field.high - field.low);
  const bool has_ends = std::isfinite(field.high - field.low) && !field.prefix && !field.whole;
  if (has_ends && t > 0) {
    const float height = std::max(2.0f, 0.1f * (high.y - low.y)), width = static_cast<float>(std::min(t, 1.0));
    list->AddRectFilled({low.x, high.y - height}, {low.x + width * (high.x - low.x), high.y}, palette::kAccent,
                        style.FrameRounding, ImDrawFlags_RoundCornersBottom);
  }
  const float room = high.x - low.x - ImGui::CalcTextSize(text.c_str()).x;
  const ImVec4 clip(low.x, low.y, high.x, high.y);
  list->AddText(panel.input.fonts.regular, panel.input.fonts.regular->FontSize,
                {low.x + std::max(style.FramePadding.x, room / 2), low.y + style.FramePadding.y},
                ImGui::GetColorU32(ImGuiCol_Text), text.c_str(), nullptr, 0, &clip);
}

/// Follows the mouse, which holds the field.
Edit follow_drag(Panel& panel, const NumberField& field, double& value) {
  const ImGuiIO& io = ImGui::GetIO();
  NumberEntry& entry = panel.state.number_entry;
  const float reach = kClickReach * ui_scale(panel);
  entry.dragged |= std::abs(io.MousePos.x - io.MouseClickedPos[0].x) > reach;
  if (ImGui::IsKeyPressed(key::kEscape, false)) {
    const bool changed = value != entry.start;
    value = entry.start;
    entry = {};
    return {changed, true};
  }
  const double pace = io.KeyShift ? 0.1 : io.KeyCtrl ? 10 : 1;
  const double way = entry.way + pace * io.MouseDelta.x;
  if (!entry.dragged || io.MouseDelta.x == 0) {
    entry.way = way;
    return {};
  }
  const double wanted = dragged_value(field, entry.start, way, io.KeyCtrl && !io.KeyShift);
  const bool at_end = wanted <= field.numbers.minimum || wanted >= field.numbers.maximum;
  if (!at_end || wanted != value) entry.way = way;  // what leads beyond an end need not be taken back
  const bool changed = wanted != value;
  value = wanted;
  entry.changed |= changed;
  return {changed, false};
}

/// The field while nothing is typed: click or drag it.
Edit held_field(Panel& panel, const NumberField& field, double& value) {
  EditorState& state = panel.state;
  const std::string text = shown_text(field, value, shown_prefix(state, field, value));
  const bool pressed = ImGui::InvisibleButton(("##" + field.tag).c_str(),
                                              {std::max(1.0f, ImGui::CalcItemWidth()), ImGui::GetFrameHeight()},
                                              ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight);
  tag_last_item(panel.tags, field.tag, text);
  draw_box(panel, field, value, text);
  if (ImGui::IsItemHovered() || ImGui::IsItemActive()) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
  if (ImGui::IsItemHovered() && ImGui::IsMouseClicked(1)) {
    begin_typing(state, field, value);
    return {};
  }
  if (ImGui::IsItemActivated()) state.number_entry = entry_of(state, field, value);
  Edit edit;
  if (ImGui::IsItemActive() && is_entered(state, field) && ImGui::IsMouseDown(0))
    edit = follow_drag(panel, field, value);
  if (!ImGui::IsItemDeactivated() || !is_entered(state, field)) return edit;
  const NumberEntry ended = std::exchange(state.number_entry, {});
  if (pressed && !ended.dragged) begin_typing(state, field, value);
  edit.finished = ended.changed;
  return edit;
}

/// Says at the label what the value was; true when it is to be that again.
bool offers_original(const NumberField& field) {
  if (!ImGui::IsItemHovered()) return false;
  const std::string original = format_quantity(*field.original, unit_symbol(field.numbers));
  ImGui::SetTooltip("Was %s. Click to restore it.", original.c_str());
  return ImGui::IsMouseClicked(ImGuiMouseButton_Left);
}

/// `value` to a multiple of a power of ten, about as large as `step`.
double to_round(double value, double step) {
  const double unit = std::pow(10.0, std::floor(std::log10(step)));
  return unit * std::round(value / unit);
}

}  // namespace

double dragged_value(const NumberField& field, double start, double way, bool rounded) {
  constexpr double kSmallest = 0.1, kOfRange = 0.002, kWideRange = 1e4;
  double wanted = start, step = 0;
  if (field.logarithmic && start > 0) {
    wanted = start * std::exp(kSharePerPixel * way);
    step = 0.1 * wanted;
  } else {
    const double range = field.high - field.low;
    const double smallest = field.numbers.minimum > 0 ? field.numbers.minimum : std::min(kSmallest, field.high);
    const double per_pixel =
        range < kWideRange ? kOfRange * range : kSharePerPixel * std::max(std::abs(start), smallest);
    step = field.whole ? std::max(kSmallest, kSharePerPixel * std::abs(start)) : per_pixel;
    wanted = start + way * step;
    step *= 10;
  }
  if (rounded && way != 0) wanted = to_round(wanted, step);
  if (field.whole) wanted = std::round(wanted);
  return std::clamp(wanted, field.numbers.minimum, field.numbers.maximum);
}

Edit quantity_box(Panel& panel, const NumberField& field, double& value) {
  EditorState& state = panel.state;
  state.number_tags.push_back(field.tag);
  if (state.opened_number == field.tag) {
    state.opened_number.clear();
    begin_typing(state, field, value);
    ImGui::SetScrollHereY();
  }
  if (is_entered(state, field) && state.number_entry.typing) return typed_entry(panel, field, value);
  const Edit edit = held_field(panel, field, value);
  field_tooltip(panel, field.tag, field.tooltip);
  return edit;
}

Edit quantity_row(Panel& panel, const NumberField& field, double& value) {
  const bool is_edited = field.original && *field.original != value;
  row_label(panel, field.label.c_str(), is_edited ? palette::kAccent : palette::kTextDim);
  const bool is_reset = is_edited && offers_original(field);
  if (is_reset) value = *field.original;
  const Edit edit = quantity_box(panel, field, value);
  return is_reset ? Edit{true, true} : edit;
}

Edit integer_row(Panel& panel, const char* tag, const char* label, int& value, const Numbers& numbers,
                 const std::string& tooltip) {
  double number = value;
  const Edit edit =
      quantity_row(panel, {.tag = tag, .label = label, .numbers = numbers, .tooltip = tooltip, .whole = true}, number);
  value = static_cast<int>(number);
  return edit;
}

}  // namespace griffith::ui
