#include "ui/widgets/number_field.h"

#include <imgui_internal.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include "ui/model/number_drag.h"
#include "ui/model/quantity_parser.h"
#include "ui/widgets/style.h"

namespace griffith::ui {
namespace {

using Kind = NumberEdit::Kind;

/// Layout of a number field in this frame.
struct Place {
  ImRect box;
  ImGuiID id = 0;
};

std::string_view unit_of(const NumberField& field) { return unit_symbol(field.numbers); }

/// Returns the shown unit: "mm", or "" for a ratio.
std::string shown_unit(const NumberField& field, const SiPrefix& prefix) {
  return std::string(prefix.symbol).append(unit_of(field));
}

SiPrefix prefix_of(const NumberEdit& edit, const NumberField& field, double value) {
  if (edit.is_of(field.tag)) return edit.prefix;
  return field.prefix.value_or(si_prefix(value, unit_of(field)));
}

/// Formats the number with as many digits as fit, and its unit unless the row names it.
std::string shown_text(const NumberField& field, double value, const SiPrefix& prefix, float width) {
  if (field.whole) return std::to_string(std::llround(value));
  if (field.names_unit) return format_quantity(value, unit_of(field), prefix);
  const float room = width - 2 * ImGui::GetStyle().FramePadding.x;
  for (int digits = 5; digits > 1; --digits) {
    const std::string text = format_number(value, prefix, digits);
    if (ImGui::CalcTextSize(text.c_str()).x <= room) return text;
  }
  return fitted(format_number(value, prefix, 1), room);
}

void begin_edit(NumberEdit& edit, Kind kind, const NumberField& field, double value) {
  const SiPrefix prefix = prefix_of(edit, field, value);
  edit = {.kind = kind, .tag = field.tag, .start = value, .prefix = prefix, .drawn_frame = ImGui::GetFrameCount()};
}

/// Gives the item the keyboard focus in this frame, as ImGui's own number fields do when they turn into text.
void begin_typing(NumberEdit& edit, const NumberField& field, double value, ImGuiID id) {
  begin_edit(edit, Kind::typed, field, value);
  edit.opened_text = exact_number(value, edit.prefix);
  if (field.names_unit) edit.opened_text = with_unit(edit.opened_text, unit_of(field), edit.prefix);
  std::snprintf(edit.text.data(), edit.text.size(), "%s", edit.opened_text.c_str());
  edit.opened_time = ImGui::GetTime();
  edit.opened_frame = ImGui::GetFrameCount();
  ImGuiContext& context = *ImGui::GetCurrentContext();
  context.NavActivateId = context.NavActivateInputId = id;
  context.NavActivateFlags = ImGuiActivateFlags_PreferInput;
}

/// Parses the typed text; else sets the problem.
std::optional<double> read_typed(const NumberEdit& edit, const NumberField& field, std::string& problem) {
  const std::string text = edit.text.data(), unit = shown_unit(field, edit.prefix);
  const std::optional<double> parsed = parse_quantity(text, unit_of(field), edit.prefix);
  if (parsed && (!field.whole || *parsed == std::round(*parsed))) return parsed;
  const std::string typed = typed_unit(unit_of(field), edit.prefix);
  problem = "\"" + text + "\" is not a " + (field.whole ? "integer" : "number") + (unit.empty() ? "" : " of " + unit) +
            (typed == unit ? "" : ", to be typed as " + typed) + ". Allowed: " + range_text_with_prefix(field.numbers) +
            ".";
  return std::nullopt;
}

/// Returns the value that the text would give: "= 100 mm".
std::string meaning(const NumberEdit& edit, const NumberField& field) {
  std::string problem;
  const std::optional<double> parsed = read_typed(edit, field, problem);
  if (!parsed) return problem;
  const double taken = std::clamp(*parsed, field.numbers.minimum, field.numbers.maximum);
  const std::string shown = "= " + with_unit(exact_number(taken, edit.prefix), unit_of(field), edit.prefix);
  return taken == *parsed ? shown : shown + ". Allowed: " + range_text_with_prefix(field.numbers) + ".";
}

/// Applies the typed text; a note reports a value that was rejected or clamped.
Edit take_typed(Panel& panel, const NumberField& field, double& value) {
  const NumberEdit edit = std::exchange(panel.state.number, {});
  panel.state.kept_unit = {field.tag, edit.prefix, ImGui::GetFrameCount()};
  if (edit.text.data() == edit.opened_text) return {};
  panel.state.field_note = {};
  std::string problem;
  const std::optional<double> parsed = read_typed(edit, field, problem);
  if (!parsed) {
    panel.state.field_note = {field.tag, problem + " The value was not changed."};
    return {};
  }
  const double clamped = std::clamp(*parsed, field.numbers.minimum, field.numbers.maximum);
  if (clamped != *parsed) panel.state.field_note = {field.tag, clamped_note(*parsed, field.numbers)};
  const bool changed = clamped != value;
  value = clamped;
  return {changed, changed};
}

/// Selects the whole text again at the second click of a double click.
void choose_all_on_double_click(const NumberEdit& edit, const Place& place) {
  constexpr double kLongest = 0.6;  // [s]
  constexpr int kFrames = 6;        // slow frames see clicks late
  const bool soon =
      ImGui::GetTime() - edit.opened_time < kLongest || ImGui::GetFrameCount() - edit.opened_frame <= kFrames;
  if (!soon || !ImGui::IsMouseClicked(0) || !place.box.Contains(ImGui::GetIO().MousePos)) return;
  if (ImGuiInputTextState* text = ImGui::GetInputTextState(place.id)) {
    text->SelectAll();
    text->SelectedAllMouseLock = true;
  }
}

/// Draws the text box that replaces the number while a value is typed.
Edit typed_entry(Panel& panel, const NumberField& field, const Place& place, double& value) {
  NumberEdit& edit = panel.state.number;
  const bool entered = ImGui::TempInputText(place.box, place.id, ("##" + field.tag).c_str(), edit.text.data(),
                                            static_cast<int>(edit.text.size()),
                                            ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
  choose_all_on_double_click(edit, place);
  tag_last_item(panel.tags, field.tag, edit.text.data());
  if (ImGui::GetActiveID() == place.id && ImGui::IsKeyPressed(key::kTab)) {
    ImGui::ClearActiveID();
  } else if (!entered && ImGui::GetActiveID() == place.id) {
    const std::string text = meaning(edit, field);
    draw_bubble(text, palette::kAccent);
    tag_last_item(panel.tags, "typed_meaning", text);
    return {};
  }
  if (!ImGui::IsKeyPressed(key::kEscape, false)) return take_typed(panel, field, value);
  edit = {};
  return {};
}

void draw_number(const Place& place, const std::string& text, bool lit) {
  const bool held = ImGui::GetActiveID() == place.id;
  const ImU32 color = ImGui::GetColorU32(held  ? ImGuiCol_FrameBgActive
                                         : lit ? ImGuiCol_FrameBgHovered
                                               : ImGuiCol_FrameBg);
  ImGui::RenderNavHighlight(place.box, place.id);
  ImGui::RenderFrame(place.box.Min, place.box.Max, color, true, ImGui::GetStyle().FrameRounding);
  ImGui::RenderTextClipped(place.box.Min, place.box.Max, text.c_str(), nullptr, nullptr, {0.5f, 0.5f});
}

/// Applies the motion of the mouse that holds the number. Nothing changes within the distance of a click.
Edit drag_on(Panel& panel, const NumberField& field, double& value) {
  NumberEdit& edit = panel.state.number;
  const ImGuiIO& io = ImGui::GetIO();
  const float threshold = 3 * ui_scale(panel), way = io.MousePos.x - io.MouseClickedPos[0].x;
  const DragPace pace = {.fine = io.KeyShift, .coarse = io.KeyCtrl};
  if (edit.kind == Kind::dragged) {
    edit.moved += static_cast<double>(io.MouseDelta.x) * pace.factor();
  } else if (std::abs(way) > threshold) {
    edit.kind = Kind::dragged;
    edit.moved = static_cast<double>(way - std::copysign(threshold, way)) * pace.factor();
  }
  if (edit.kind != Kind::dragged) return {};
  const double dragged = dragged_number({.value = edit.start,
                                         .numbers = field.numbers,
                                         .whole = field.whole,
                                         .vector_magnitude = field.vector_magnitude,
                                         .usual = field.usual},
                                        edit.moved, pace);
  const bool changed = dragged != value;
  value = dragged;
  return {changed, false};
}

Edit revert_drag(NumberEdit& edit, double& value) {
  ImGui::ClearActiveID();
  const double start = std::exchange(edit, {}).start;
  const bool changed = value != start;
  value = start;
  return {changed, true};
}

/// Handles the mouse over a number that is not typed into.
Edit held_number(Panel& panel, const NumberField& field, const Place& place, double& value, bool& opens) {
  NumberEdit& edit = panel.state.number;
  bool hovered = false, held = false;
  const bool clicked = ImGui::ButtonBehavior(place.box, place.id, &hovered, &held);
  if (hovered || held) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
  const bool is_free = edit.kind != Kind::typed;  // else the field that is typed into first takes its text
  if (held && is_free && !edit.is_of(field.tag)) begin_edit(edit, Kind::held, field, value);
  opens = hovered && ImGui::IsMouseClicked(1);
  if (!edit.is_of(field.tag)) {
    opens |= clicked;
    return {};
  }
  if (held && ImGui::IsKeyPressed(key::kEscape, false)) return revert_drag(edit, value);
  if (held) return drag_on(panel, field, value);
  const bool dragged = std::exchange(edit, {}).kind == Kind::dragged;
  opens |= clicked && !dragged;
  return {false, dragged};
}

/// Ends an edit whose field is no longer drawn.
void forget_undrawn(NumberEdit& edit) {
  if (edit.kind != Kind::none && ImGui::GetFrameCount() - edit.drawn_frame > 1) edit = {};
}

/// Shows the original value at the label. True if it is to be restored.
bool offers_original(const NumberField& field) {
  if (!ImGui::IsItemHovered()) return false;
  const std::string original = format_quantity(*field.original, unit_of(field));
  ImGui::SetTooltip("Original: %s. Click to restore it.", original.c_str());
  return ImGui::IsMouseClicked(ImGuiMouseButton_Left);
}

}  // namespace

Edit number_field(Panel& panel, const NumberField& field, double& value) {
  NumberEdit& edit = panel.state.number;
  forget_undrawn(edit);
  const ImVec2 corner = ImGui::GetCursorScreenPos(), size(ImGui::CalcItemWidth(), ImGui::GetFrameHeight());
  const Place place = {{corner, {corner.x + size.x, corner.y + size.y}}, ImGui::GetID(("##" + field.tag).c_str())};
  ImGui::ItemSize(size, ImGui::GetStyle().FramePadding.y);
  const bool seen = ImGui::ItemAdd(place.box, place.id, nullptr, ImGuiItemFlags_Inputable);
  if (edit.is_of(field.tag)) edit.drawn_frame = ImGui::GetFrameCount();
  Edit result;
  if (edit.is_of(field.tag) && edit.kind == Kind::typed) {
    if (ImGui::GetActiveID() == place.id) return typed_entry(panel, field, place, value);
    result = take_typed(panel, field, value);  // another item took the keyboard focus
  }
  bool opens = ImGui::GetCurrentContext()->NavActivateInputId == place.id || panel.state.number_to_open == field.tag;
  if (!opens && seen) {
    const Edit by_mouse = held_number(panel, field, place, value, opens);
    result = {result.changed || by_mouse.changed, result.finished || by_mouse.finished};
  }
  if (opens && edit.kind == Kind::typed) {  // opens in the next frame, after the other field has taken its text
    ImGui::ClearActiveID();
    panel.state.number_to_open = field.tag;
  } else if (opens) {
    panel.state.number_to_open.clear();
    begin_typing(edit, field, value, place.id);
    const Edit typed = typed_entry(panel, field, place, value);
    return {result.changed || typed.changed, result.finished || typed.finished};
  }
  const std::string text = shown_text(field, value, prefix_of(edit, field, value), size.x);
  if (seen) draw_number(place, text, ImGui::IsItemHovered());
  tag_last_item(panel.tags, field.tag, text);
  field_tooltip(panel, field.tag, field.tooltip);
  return result;
}

Edit number_field_row(Panel& panel, const NumberField& field, double& value) {
  const bool is_edited = field.original && *field.original != value;
  row_label(panel, field.label.c_str(), is_edited ? palette::kAccent : palette::kTextDim);
  const bool is_reset = is_edited && offers_original(field);
  if (is_reset) value = *field.original;
  if (is_reset && panel.state.number.is_of(field.tag)) panel.state.number = {};
  const Edit edit = number_field(panel, field, value);
  return is_reset ? Edit{true, true} : edit;
}

Edit number_field_row(Panel& panel, NumberField field, int& value) {
  field.whole = true;
  double number = value;
  const Edit edit = number_field_row(panel, std::as_const(field), number);
  value = static_cast<int>(std::lround(number));
  return edit;
}

std::optional<SiPrefix> ongoing_prefix(const EditorState& state, std::string_view tag) {
  constexpr int kFramesToNext = 4;  // within which Tab or a click opens another number of the row
  const NumberEdit& edit = state.number;
  if (edit.kind != NumberEdit::Kind::none && edit.tag.starts_with(tag)) return edit.prefix;
  const KeptUnit& kept = state.kept_unit;
  const bool goes_on = kept.tag.starts_with(tag) && ImGui::GetFrameCount() - kept.frame <= kFramesToNext;
  return goes_on ? std::optional(kept.prefix) : std::nullopt;
}

SiPrefix shared_prefix(const EditorState& state, std::string_view tag, double largest, std::string_view unit) {
  return ongoing_prefix(state, tag).value_or(si_prefix(largest, unit));
}

}  // namespace griffith::ui
