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

/// Moves the choice with the arrow keys. True if it moved.
bool move_choice(int& chosen, int count) {
  const int before = chosen;
  if (ImGui::IsKeyPressed(key::kDown)) ++chosen;
  if (ImGui::IsKeyPressed(key::kUp)) --chosen;
  chosen = std::clamp(chosen, 0, std::max(0, count - 1));
  return chosen != before;
}

/// An entry of the palette: a command or a macro.
struct PaletteItem {
  Command command;
  std::string name, title, place, shortcut, hint;
  std::string disabled_reason;  ///< reason why it cannot run now; empty if it can
};

PaletteItem item_of(const CommandInfo& info, const Panel& panel, const std::vector<double>& numbers) {
  return {with_numbers(info, numbers).value_or(Command{.name = info.name}),
          std::string(info.name),
          std::string(info.label),
          menu_label(info.menu),
          shortcut_text(info.shortcut),
          std::string(info.hint),
          std::string(disabled_reason(info, panel))};
}

/// Returns the commands that match, best first, then the macros that match.
std::vector<PaletteItem> matching_items(const Panel& panel, std::string_view query) {
  std::vector<PaletteItem> items;
  const std::vector<double> numbers = parse_command_query(query).numbers;
  for (const CommandInfo* info : matching_commands(panel.input.commands, query))
    items.push_back(item_of(*info, panel, numbers));
  for (const std::filesystem::path& macro : panel.input.macros) {
    const std::string title = macro.stem().string();
    if (match_score("Macro " + title, query))
      items.push_back({{.name = "edit.play_macro", .path = macro},
                       "macro/" + title,
                       title,
                       "Macro",
                       "",
                       "Play " + macro.string(),
                       ""});
  }
  return items;
}

/// Draws an entry: title, menu, shortcut. True if it was clicked.
bool palette_row(Panel& panel, const PaletteItem& item, bool chosen) {
  const bool enabled = item.disabled_reason.empty();
  const float width = ImGui::GetContentRegionAvail().x;
  const bool clicked = ImGui::Selectable(("##" + item.name).c_str(), chosen);
  tag_last_item(panel.tags, "palette/" + item.name, item.title, enabled);
  ImGui::SameLine(ImGui::GetStyle().ItemSpacing.x);
  ImGui::TextColored(as_vec4(enabled ? palette::kText : palette::kTextDim), "%s", item.title.c_str());
  ImGui::SameLine(width * 0.6f);
  ImGui::TextColored(as_vec4(palette::kTextDim), "%s", item.place.c_str());
  ImGui::SameLine(width * 0.8f);
  ImGui::TextColored(as_vec4(palette::kAccent), "%s", item.shortcut.c_str());
  return clicked;
}

/// Shows the help of the chosen entry, or the reason why it cannot run now.
void describe(const Panel& panel, const PaletteItem* chosen) {
  const std::string reason =
      chosen ? chosen->disabled_reason : problem_of_query(panel.input.commands, panel.state.palette.text.data());
  const std::string text = reason.empty() ? chosen->hint : reason;
  wrapped_text(text, reason.empty() ? palette::kTextDim : palette::kWarning);
  tag_last_item(panel.tags, "palette/help", text);
}

bool text_field(Panel& panel) {
  Palette& palette = panel.state.palette;
  if (ImGui::IsWindowAppearing()) ImGui::SetKeyboardFocusHere();
  ImGui::SetNextItemWidth(-FLT_MIN);
  const bool entered = ImGui::InputTextWithHint("##query", "search commands", palette.text.data(), palette.text.size(),
                                                ImGuiInputTextFlags_EnterReturnsTrue);
  if (ImGui::IsItemEdited()) palette.chosen = 0;
  tag_last_item(panel.tags, "palette/text", palette.text.data());
  return entered;
}

/// Draws the list. Returns the clicked entry, or nullptr.
const PaletteItem* list_of_items(Panel& panel, std::span<const PaletteItem> items) {
  const bool moved = move_choice(panel.state.palette.chosen, static_cast<int>(items.size()));
  const PaletteItem* clicked = nullptr;
  ImGui::BeginChild("##commands", {0, kLinesShown * ImGui::GetTextLineHeightWithSpacing()});
  for (std::size_t i = 0; i < items.size(); ++i) {
    const bool chosen = static_cast<int>(i) == panel.state.palette.chosen;
    if (palette_row(panel, items[i], chosen)) clicked = &items[i];
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
  const std::vector<PaletteItem> items = matching_items(panel, palette.text.data());
  const PaletteItem* picked = list_of_items(panel, items);
  const PaletteItem* chosen = items.empty() ? nullptr : &items[static_cast<std::size_t>(palette.chosen)];
  describe(panel, chosen);
  if (entered) {
    picked = chosen;
    ImGui::SetKeyboardFocusHere(-1);
  }
  const bool carried_out = picked && picked->disabled_reason.empty();
  if (carried_out) issue(panel, picked->command);
  if (carried_out || ImGui::IsKeyPressed(key::kEscape, false)) {
    palette = {};
    ImGui::CloseCurrentPopup();
  }
  ImGui::EndPopup();
}

}  // namespace griffith::ui
