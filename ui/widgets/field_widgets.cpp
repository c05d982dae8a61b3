#include "ui/widgets/field_widgets.h"

#include <imgui_stdlib.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <optional>

#include "ui/widgets/number_field.h"
#include "ui/widgets/style.h"

namespace griffith::ui {
namespace {

/// Returns the label without the unit at its end, which the row shows elsewhere.
std::string label_without_unit(const FieldRow& row) { return row.label.substr(0, row.label.find(" degrees")); }

NumberField number_field_of(const FieldRow& row, const Numbers& numbers) {
  return {.tag = row.tag, .label = label_without_unit(row), .numbers = numbers, .tooltip = row.description};
}

/// Returns the label of a row of several numbers with their unit: "Size [mm]".
std::string label_with_unit(const FieldRow& row, const SiPrefix& prefix, const Numbers& numbers) {
  const std::string unit = std::string(prefix.symbol) + std::string(unit_symbol(numbers));
  const std::string label = label_without_unit(row);
  return unit.empty() ? label : label + " [" + unit + "]";
}

/// Draws a text box over the rest of the row; `finished` when it loses the focus or Enter is pressed. A right click
/// begins to type, as in number fields.
Edit text_box(Panel& panel, const FieldRow& row, std::string& value, ImGuiInputTextFlags flags = 0) {
  std::string text = value;
  const bool entered = ImGui::InputText(("##" + row.tag).c_str(), &text, flags | ImGuiInputTextFlags_AutoSelectAll);
  if (ImGui::IsItemClicked(ImGuiMouseButton_Right)) ImGui::SetKeyboardFocusHere(-1);
  Edit edit;
  edit.finished = ImGui::IsItemDeactivatedAfterEdit();
  tag_last_item(panel.tags, row.tag, value);
  field_tooltip(panel, row.tag, row.description);
  edit.changed = entered && value != text;
  if (entered) value = text;
  return edit;
}

/// Parses integers separated by commas and spaces; empty if the text contains anything else.
std::optional<std::vector<int>> parse_list(const std::string& text, const Numbers& numbers) {
  std::vector<int> values;
  const char *at = text.data(), *end = at + text.size();
  while (at != end) {
    if (*at == ',' || *at == ' ') {
      ++at;
      continue;
    }
    int value = 0;
    const auto [next, error] = std::from_chars(at, end, value);
    if (error != std::errc() || value < numbers.minimum || value > numbers.maximum) return std::nullopt;
    values.push_back(value);
    at = next;
  }
  return values;
}

std::string list_text(const std::vector<int>& values) {
  std::string text;
  for (const int value : values) text += (text.empty() ? "" : ", ") + std::to_string(value);
  return text;
}

}  // namespace

Edit draw_field(Panel& panel, const FieldRow& row, const Numbers& numbers, double& value) {
  return number_field_row(panel, number_field_of(row, numbers), value);
}

Edit draw_field(Panel& panel, const FieldRow& row, const Numbers& numbers, int& value) {
  return number_field_row(panel, number_field_of(row, numbers), value);
}

Edit draw_field(Panel& panel, const FieldRow& row, const Numbers& numbers, std::span<double> components,
                const SiPrefix& prefix) {
  wide_row_label(panel, label_with_unit(row, prefix, numbers).c_str());
  const float gap = 3 * ui_scale(panel), count = static_cast<float>(components.size());
  const float width = (ImGui::GetContentRegionAvail().x - (count - 1) * gap) / count;
  NumberField field = number_field_of(row, numbers);
  field.prefix = prefix;
  field.names_unit = false;
  for (const double component : components)
    field.vector_magnitude = std::max(field.vector_magnitude, std::abs(component));
  Edit edit;
  for (std::size_t i = 0; i < components.size(); ++i) {
    if (i > 0) ImGui::SameLine(0, gap);
    ImGui::SetNextItemWidth(width);
    field.tag = row.tag + "/" + std::to_string(i);
    const Edit of_part = number_field(panel, field, components[i]);
    edit.changed |= of_part.changed;
    edit.finished |= of_part.finished;
  }
  return edit;
}

Edit draw_field(Panel& panel, const FieldRow& row, const Numbers& numbers, std::vector<int>& values) {
  row_label(panel, row.label.c_str());
  std::string text = list_text(values);
  const Edit typed = text_box(panel, row, text, ImGuiInputTextFlags_EnterReturnsTrue);
  if (!typed.changed) return {};
  std::optional<std::vector<int>> parsed = parse_list(text, numbers);
  if (!parsed) {
    panel.state.field_note = {
        row.tag, "\"" + text + "\" is not a list of integers, each " + range_text(numbers) + ", separated by commas."};
    return {};
  }
  const bool changed = *parsed != values;
  values = std::move(*parsed);
  return {changed, changed};
}

Edit draw_field(Panel& panel, const FieldRow& row, Flag, bool& value) {
  row_label(panel, row.label.c_str());
  const bool toggled = checkbox(panel, row.tag.c_str(), ("##" + row.tag).c_str(), value);
  field_tooltip(panel, row.tag, row.description);
  return {toggled, toggled};
}

Edit draw_field(Panel& panel, const FieldRow& row, const Text& text, std::string& value) {
  row_label(panel, row.label.c_str());
  std::string typed = value;
  Edit edit = text_box(panel, row, typed);
  if (typed.size() < static_cast<std::size_t>(text.minimum_length)) {
    const bool leaves = ImGui::IsMouseClicked(ImGuiMouseButton_Left);
    if (!leaves) panel.state.field_note = {row.tag, row.label + " cannot be empty: it stays \"" + value + "\"."};
    return {false, edit.finished};
  }
  value = std::move(typed);
  return edit;
}

Edit draw_field(Panel& panel, const FieldRow& row, const std::filesystem::path& folder, std::filesystem::path& value) {
  row_label(panel, row.label.c_str());
  std::string text = value.generic_string();
  if (!text_box(panel, row, text, ImGuiInputTextFlags_EnterReturnsTrue).changed) return {};
  if (text.empty() || !std::filesystem::exists(folder / text)) {
    panel.state.field_note = {row.tag, "There is no file or folder \"" + text + "\"."};
    return {};
  }
  value = text;
  return {true, true};
}

Edit draw_choice(Panel& panel, const FieldRow& row, const OneOf& one_of, int& value) {
  std::vector<std::string> names;
  for (const std::string_view name : one_of.names) names.push_back(words_of(name));
  const int chosen =
      combo_row(panel, row.tag.c_str(), row.label.c_str(), names, names[static_cast<std::size_t>(value)]);
  field_tooltip(panel, row.tag, row.description);
  if (chosen < 0 || chosen == value) return {};
  value = chosen;
  return {true, true};
}

Edit draw_choices(Panel& panel, const FieldRow& row, const OneOf& one_of, std::vector<int>& chosen) {
  row_label(panel, row.label.c_str());
  const std::string text = std::to_string(chosen.size()) + " chosen";
  if (!begin_combo(("##" + row.tag).c_str(), text.c_str())) {
    tag_last_item(panel.tags, row.tag, text);
    field_tooltip(panel, row.tag, row.description);
    return {};
  }
  Edit edit;
  for (int i = 0; i < static_cast<int>(one_of.names.size()); ++i) {
    bool on = std::ranges::find(chosen, i) != chosen.end();
    const std::string name(one_of.names[static_cast<std::size_t>(i)]);
    if (!checkbox(panel, (row.tag + "/" + name).c_str(), words_of(name).c_str(), on)) continue;
    if (on) chosen.push_back(i);
    if (!on) std::erase(chosen, i);
    edit = {true, true};
  }
  ImGui::EndCombo();
  return edit;
}

Edit draw_presence(Panel& panel, const FieldRow& row, bool& present) {
  row_label(panel, row.label.c_str());
  const bool toggled = checkbox(panel, row.tag.c_str(), ("##" + row.tag).c_str(), present);
  field_tooltip(panel, row.tag, row.description);
  return {toggled, toggled};
}

bool begin_part(Panel& panel, const FieldRow& row, const std::string& summary) {
  open_if_sought(panel, row.tag);
  const bool open = ImGui::TreeNodeEx(row.tag.c_str(), ImGuiTreeNodeFlags_SpanAvailWidth, "%s", row.label.c_str());
  tag_last_item(panel.tags, row.tag, open ? "open" : "closed");
  field_tooltip(panel, row.tag, row.description);
  if (!summary.empty()) {
    ImGui::SameLine();
    ImGui::TextColored(as_vec4(palette::kTextDim), "%s", summary.c_str());
  }
  return open;
}

void end_part() { ImGui::TreePop(); }

std::string words_of(std::string_view name) {
  std::string words(name);
  std::ranges::replace(words, '_', ' ');
  return words;
}

std::string label_of(std::string_view name) {
  std::string label = words_of(name);
  if (!label.empty() && label.front() >= 'a' && label.front() <= 'z') label.front() -= 'a' - 'A';
  return label;
}

}  // namespace griffith::ui
