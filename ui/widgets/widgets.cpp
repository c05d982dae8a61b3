#include "ui/widgets/widgets.h"

#include <algorithm>

#include "ui/model/units.h"
#include "ui/widgets/style.h"

namespace griffith::ui {

std::string fitted(std::string_view text, float width) {
  const auto width_of = [](std::string_view part) {
    return ImGui::CalcTextSize(part.data(), part.data() + part.size()).x;
  };
  if (width_of(text) <= width) return std::string(text);
  const auto ends_within_letter = [&text] { return (text.back() & 0xc0) == 0x80; };
  const float room = width - width_of("…");
  while (!text.empty() && (width_of(text) > room || text.back() == ' ')) {
    while (ends_within_letter()) text.remove_suffix(1);
    text.remove_suffix(1);
  }
  return std::string(text) + "…";
}

float ui_scale(const Panel& panel) { return panel.input.fonts.regular->FontSize / 16; }

void heading(const Panel& panel, const char* text) {
  ImGui::Dummy({0, 2 * ui_scale(panel)});
  ImGui::PushFont(panel.input.fonts.bold);
  ImGui::PushStyleColor(ImGuiCol_Text, palette::kAccent);
  ImGui::TextUnformatted(fitted(text, ImGui::GetContentRegionAvail().x).c_str());
  ImGui::PopStyleColor();
  ImGui::PopFont();
  ImGui::Separator();
  ImGui::Dummy({0, ui_scale(panel)});
}

void row_label(const Panel& panel, const char* label, ImU32 color) {
  const float column = std::max(124 * ui_scale(panel), 0.42f * ImGui::GetWindowWidth());
  const bool fits = ImGui::GetCursorPosX() + ImGui::CalcTextSize(label).x + 4 * ui_scale(panel) <= column;
  wide_row_label(panel, label, color);
  if (fits) {
    ImGui::SameLine(column);
  } else {
    ImGui::SetCursorPosX(column);
  }
  ImGui::SetNextItemWidth(-FLT_MIN);
}

void wide_row_label(const Panel& panel, const char* label, ImU32 color) {
  ImGui::AlignTextToFramePadding();
  ImGui::PushStyleColor(ImGuiCol_Text, color);
  ImGui::TextUnformatted(label);
  ImGui::PopStyleColor();
  panel.tags.push_back({std::string("label/") + label, ImGui::GetItemRectMin(), ImGui::GetItemRectMax(), label});
}

void value_row(const Panel& panel, const char* label, const std::string& value, ImU32 color) {
  value_row(panel, (std::string("value/") + label).c_str(), label, value, color);
}

void value_row(const Panel& panel, const char* tag, const char* label, const std::string& value, ImU32 color) {
  const float start = ImGui::GetCursorPosX(), end = start + ImGui::GetContentRegionAvail().x;
  const float place = end - ImGui::CalcTextSize(value.c_str()).x;
  ImGui::TextColored(as_vec4(palette::kTextDim), "%s", label);
  ImGui::SameLine();
  if (ImGui::GetCursorPosX() > place) ImGui::NewLine();  // no room for both
  ImGui::SetCursorPosX(std::max(start, place));
  ImGui::TextColored(as_vec4(color), "%s", value.c_str());
  tag_last_item(panel.tags, tag, value);
}

std::string broken_into_lines(std::string_view text, float width) {
  std::string lines(text);
  std::size_t start = 0, last_space = std::string::npos;
  for (std::size_t i = 0; i <= lines.size(); ++i) {
    if (i < lines.size() && lines[i] != ' ' && lines[i] != '\n') continue;
    const bool too_wide = ImGui::CalcTextSize(lines.data() + start, lines.data() + i).x > width;
    if (too_wide && last_space != std::string::npos) {
      lines[last_space] = '\n';
      start = last_space + 1;
    }
    last_space = i;
    if (i < lines.size() && lines[i] == '\n') start = i + 1, last_space = std::string::npos;
  }
  return lines;
}

void wrapped_text(std::string_view text, ImU32 color) {
  ImGui::PushStyleColor(ImGuiCol_Text, color);
  ImGui::TextUnformatted(broken_into_lines(text, ImGui::GetContentRegionAvail().x).c_str());
  ImGui::PopStyleColor();
}

void hint(const Panel& panel, const std::string& text) {
  ImGui::PushFont(panel.input.fonts.small);
  wrapped_text(text, palette::kTextDim);
  ImGui::PopFont();
}

namespace {

/// Scrolls to the sought field or its visible part: a section around it, or the first of its numbers.
void scroll_if_sought(const Panel& panel, std::string_view tag) {
  EditorState& state = panel.state;
  if (!is_within(state.sought.tag + "/0", tag)) return;
  ImGui::SetScrollHereY();
  if (!state.field_note.tag.empty()) state.field_note.tag = tag;
}

}  // namespace

void field_tooltip(const Panel& panel, std::string_view tag, std::string_view text) {
  if (panel.state.sought.frames > 0) return scroll_if_sought(panel, tag);
  const FieldNote& note = panel.state.field_note;
  if (note.tag.empty() || note.tag != tag) return tooltip(text);
  if (!ImGui::IsItemVisible()) return;
  const float width = ui_scale(panel);
  ImGui::GetWindowDrawList()->AddRect(ImGui::GetItemRectMin(), ImGui::GetItemRectMax(), palette::kWarning,
                                      ImGui::GetStyle().FrameRounding, 0, width);
  draw_bubble(note.text, palette::kWarning);
  tag_last_item(panel.tags, "field_note", note.text);
}

void command_button(Panel& panel, std::string_view name, Icon icon, bool with_label, bool lit) {
  const CommandInfo& info = command_info(name, panel);
  const bool enabled = command_enabled(info, panel);
  const float size = ImGui::GetFrameHeight(), scale = ui_scale(panel);
  const std::string label(info.label);
  const float text_width = with_label ? ImGui::CalcTextSize(label.c_str()).x + 8 * scale : 0;
  ImGui::BeginDisabled(!enabled);
  ImGui::PushStyleColor(ImGuiCol_Button, lit ? palette::kAccentDim : palette::kField);
  const std::string item = "##" + std::string(info.name);
  if (ImGui::Button(item.c_str(), {size * 1.25f + text_width, size})) issue(panel, {.name = info.name});
  ImGui::PopStyleColor();
  tag_last_item(panel.tags, "command/" + std::string(info.name), label, enabled);
  const ImVec2 corner = ImGui::GetItemRectMin();
  const ImU32 color = ImGui::GetColorU32(lit ? palette::kAccent : palette::kText);
  draw_icon(ImGui::GetWindowDrawList(), icon, {corner.x + 0.625f * size, corner.y + 0.5f * size}, 0.5f * size, color);
  if (with_label) {
    ImGui::GetWindowDrawList()->AddText({corner.x + 1.15f * size, corner.y + ImGui::GetStyle().FramePadding.y}, color,
                                        label.c_str());
  }
  ImGui::EndDisabled();
  std::string text(info.hint);
  if (info.shortcut.key != key::kNone) text.append("  (").append(shortcut_text(info.shortcut)).append(")");
  if (!enabled) text.append("\n").append(disabled_reason(info, panel));
  tooltip(text);
}

void command_menu_item(Panel& panel, const CommandInfo& info, const char* tag_prefix) {
  const bool enabled = command_enabled(info, panel);
  const std::string label(info.label), shortcut = shortcut_text(info.shortcut);
  if (ImGui::MenuItem(label.c_str(), shortcut.c_str(), is_on(info, panel), enabled)) issue(panel, {.name = info.name});
  tag_last_item(panel.tags, tag_prefix + std::string(info.name), label, enabled);
  tooltip(disabled_reason(info, panel));
}

bool begin_combo(const char* item, const char* preview) {
  if (!ImGui::BeginCombo(item, preview, ImGuiComboFlags_HeightLargest)) return false;
  close_on_escape();
  return true;
}

void close_on_escape() {
  const ImGuiIO& io = ImGui::GetIO();
  const bool pressed_last_frame = io.KeysDownDurationPrev[key::kEscape] == 0, was_typing = io.WantTextInput;
  if (pressed_last_frame && !was_typing) ImGui::CloseCurrentPopup();
}

int combo_row(Panel& panel, const char* tag, const char* label, std::span<const std::string> entries,
              std::string_view shown) {
  row_label(panel, label);
  const std::string preview(shown), item = "##" + std::string(tag);
  if (!begin_combo(item.c_str(), preview.c_str())) {
    tag_last_item(panel.tags, tag, preview);
    return -1;
  }
  int chosen = -1;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    if (ImGui::Selectable(entries[i].c_str(), entries[i] == shown)) chosen = static_cast<int>(i);
    tag_last_item(panel.tags, tag + ("/" + entries[i]), entries[i]);
  }
  ImGui::EndCombo();
  return chosen;
}

bool checkbox(Panel& panel, const char* tag, const char* label, bool& value) {
  const bool toggled = ImGui::Checkbox(label, &value);
  tag_last_item(panel.tags, tag, value ? "on" : "off");
  return toggled;
}

bool text_button(Panel& panel, const char* tag, const char* label, float width) {
  const bool clicked = ImGui::Button(label, {width, 0});
  tag_last_item(panel.tags, tag, label);
  return clicked;
}

}  // namespace griffith::ui
