#include <algorithm>
#include <cfloat>

#include "ui/dialogs/dialog_window.h"
#include "ui/dialogs/dialogs.h"
#include "ui/model/command_search.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace griffith::ui {
namespace {

constexpr int kLinesShown = 12;

/// Moves the choice with the arrow keys; true when it moved.
bool move_choice(int& chosen, int count) {
  const int before = chosen;
  if (ImGui::IsKeyPressed(key::kDown)) ++chosen;
  if (ImGui::IsKeyPressed(key::kUp)) --chosen;
  chosen = std::clamp(chosen, 0, std::max(0, count - 1));
  return chosen != before;
}

/// A line of the list: title, menu, shortcut. True when it was clicked.
bool palette_row(Panel& panel, const CommandInfo& info, bool chosen) {
  const bool enabled = command_enabled(info.id, panel);
  const std::string item = "##" + std::string(info.name), label(info.label), shortcut = shortcut_text(info.shortcut);
  const float width = ImGui::GetContentRegionAvail().x;
  const bool clicked = ImGui::Selectable(item.c_str(), chosen);
  tag_last_item(panel.tags, "palette/" + std::string(info.name), label, enabled);
  ImGui::SameLine(ImGui::GetStyle().ItemSpacing.x);
  ImGui::TextColored(as_vec4(enabled ? palette::kText : palette::kTextDim), "%s", label.c_str());
  ImGui::SameLine(width * 0.6f);
  ImGui::TextColored(as_vec4(palette::kTextDim), "%s", menu_label(info.menu));
  ImGui::SameLine(width * 0.8f);
  ImGui::TextColored(as_vec4(palette::kAccent), "%s", shortcut.c_str());
  return clicked;
}

/// What the chosen command does or, where it makes no sense now, why not.
void describe(const Panel& panel, const CommandInfo* chosen) {
  const std::string_view reason = chosen ? why_not(*chosen, panel) : "No command has these letters.";
  const std::string text(reason.empty() ? chosen->hint : reason);
  ImGui::PushTextWrapPos(0);
  ImGui::TextColored(as_vec4(reason.empty() ? palette::kTextDim : palette::kWarning), "%s", text.c_str());
  ImGui::PopTextWrapPos();
  tag_last_item(panel.tags, "palette/help", text);
}

bool text_field(Panel& panel) {
  Palette& palette = panel.state.palette;
  if (ImGui::IsWindowAppearing()) ImGui::SetKeyboardFocusHere();
  ImGui::SetNextItemWidth(-FLT_MIN);
  const bool entered = ImGui::InputTextWithHint("##wanted", "a few letters of a command", palette.text.data(),
                                                palette.text.size(), ImGuiInputTextFlags_EnterReturnsTrue);
  if (ImGui::IsItemEdited()) palette.chosen = 0;
  tag_last_item(panel.tags, "palette/text", palette.text.data());
  return entered;
}

/// The command that was clicked, or nullptr.
const CommandInfo* list_of_commands(Panel& panel, std::span<const CommandInfo* const> commands) {
  const bool moved = move_choice(panel.state.palette.chosen, static_cast<int>(commands.size()));
  const CommandInfo* clicked = nullptr;
  ImGui::BeginChild("##commands", {0, kLinesShown * ImGui::GetTextLineHeightWithSpacing()});
  for (std::size_t i = 0; i < commands.size(); ++i) {
    const bool chosen = static_cast<int>(i) == panel.state.palette.chosen;
    if (palette_row(panel, *commands[i], chosen)) clicked = commands[i];
    if (chosen && moved) ImGui::SetScrollHereY();
  }
  ImGui::EndChild();
  return clicked;
}

}  // namespace

void draw_palette_dialog(Panel& panel) {
  Palette& palette = panel.state.palette;
  if (!begin_dialog(panel, "Find a command", palette.shown, 560)) return;
  const bool entered = text_field(panel);
  const std::vector<const CommandInfo*> commands = matching_commands(palette.text.data());
  const CommandInfo* wanted = list_of_commands(panel, commands);
  const CommandInfo* chosen = commands.empty() ? nullptr : commands[static_cast<std::size_t>(palette.chosen)];
  describe(panel, chosen);
  if (entered) {
    wanted = chosen;
    ImGui::SetKeyboardFocusHere(-1);
  }
  const bool carried_out = wanted && command_enabled(wanted->id, panel);
  if (carried_out) issue(panel, {.id = wanted->id});
  if (carried_out || ImGui::IsKeyPressed(key::kEscape, false)) {
    palette = {};
    ImGui::CloseCurrentPopup();
  }
  ImGui::EndPopup();
}

}  // namespace griffith::ui
