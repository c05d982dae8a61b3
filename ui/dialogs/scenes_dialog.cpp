#include <algorithm>
#include <cfloat>
#include <cmath>

#include "ui/dialogs/dialog_window.h"
#include "ui/dialogs/dialogs.h"
#include "ui/model/scene_browser.h"
#include "ui/model/scene_names.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace griffith::ui {
namespace {

// In design pixels, except the fraction of the window.
constexpr float kMinCardWidth = 250, kGap = 12, kInset = 8, kRounding = 5, kMaxWidth = 1720, kWindowPart = 0.9f;
/// Lines that the dialog needs besides the list: heading, search, description, buttons.
constexpr float kLinesAround = 10.5f;

float card_height(const Panel& panel, float width) {
  return width * 9 / 16 + panel.input.fonts.regular->FontSize + panel.input.fonts.small->FontSize +
         2.5f * kInset * ui_scale(panel);
}

/// Draws the picture, or a dark placeholder while it is missing.
void draw_thumbnail(const Panel& panel, const SceneCard& card, ImVec2 corner, ImVec2 end) {
  ImDrawList* list = ImGui::GetWindowDrawList();
  const float rounding = kRounding * ui_scale(panel);
  if (card.thumbnail)
    return list->AddImageRounded(card.thumbnail, corner, end, {0, 0}, {1, 1}, IM_COL32_WHITE, rounding,
                                 ImDrawFlags_RoundCornersTop);
  list->AddRectFilled(corner, end, palette::kWindow, rounding, ImDrawFlags_RoundCornersTop);
  const char* text = card.readable ? "no picture yet" : "not a scene";
  const ImFont* font = panel.input.fonts.small;
  const ImVec2 size = font->CalcTextSizeA(font->FontSize, FLT_MAX, 0, text);
  list->AddText(font, font->FontSize, {(corner.x + end.x - size.x) / 2, (corner.y + end.y - size.y) / 2},
                palette::kTextDim, text);
}

void draw_title(const Panel& panel, const SceneCard& card, ImVec2 corner, float width) {
  const float inset = kInset * ui_scale(panel), room = width - 2 * inset;
  ImDrawList* list = ImGui::GetWindowDrawList();
  const ImVec2 place(corner.x + inset, corner.y + inset);
  list->AddText(place, palette::kText, fitted(card.title, room).c_str());
  const float line = ImGui::GetFontSize();
  ImGui::PushFont(panel.input.fonts.small);
  list->AddText({place.x, place.y + line + inset / 4}, card.readable ? palette::kTextDim : palette::kError,
                fitted(card.description, room).c_str());
  ImGui::PopFont();
}

/// Draws the card at the cursor. True if it was clicked.
bool scene_card(Panel& panel, const SceneCard& card, const std::string& name, bool chosen, float width) {
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const ImVec2 end(corner.x + width, corner.y + card_height(panel, width));
  const bool clicked = ImGui::InvisibleButton(("##" + name).c_str(), {width, end.y - corner.y});
  const bool hovered = ImGui::IsItemHovered();
  tag_last_item(panel.tags, "scenes/" + name, card.title, card.readable);
  if (!ImGui::IsItemVisible()) return clicked;
  ImDrawList* list = ImGui::GetWindowDrawList();
  const float scale = ui_scale(panel), rounding = kRounding * scale;
  list->AddRectFilled(corner, end, hovered || chosen ? palette::kFieldHovered : palette::kField, rounding);
  const float bottom = corner.y + width * 9 / 16;
  draw_thumbnail(panel, card, corner, {end.x, bottom});
  draw_title(panel, card, {corner.x, bottom}, width);
  if (chosen || hovered)
    list->AddRect(corner, end, chosen ? palette::kAccent : palette::kTextDim, rounding, 0, (chosen ? 2 : 1) * scale);
  return clicked;
}

/// Moves the choice with the arrow keys. True if it moved.
bool move_card_choice(SceneBrowser& browser, std::span<const CardRow> rows) {
  const int right = ImGui::IsKeyPressed(key::kRight) - ImGui::IsKeyPressed(key::kLeft);
  const int down = ImGui::IsKeyPressed(key::kDown) - ImGui::IsKeyPressed(key::kUp);
  const std::size_t before = browser.chosen;
  browser.chosen = moved_choice(rows, before, right, down);
  return browser.chosen != before;
}

bool search_field(Panel& panel, SceneBrowser& browser) {
  if (ImGui::IsWindowAppearing()) ImGui::SetKeyboardFocusHere();
  ImGui::SetNextItemWidth(-FLT_MIN);
  ImGui::InputTextWithHint("##words", "search names, topics and descriptions", browser.text.data(),
                           browser.text.size());
  const bool edited = ImGui::IsItemEdited();
  if (edited) browser.chosen = 0;
  tag_last_item(panel.tags, "scenes/text", browser.text.data());
  return edited;
}

/// Draws the topic above its first card, repeated above the first card of each row.
void topic_heading(const Panel& panel, const std::string& topic, float width) {
  ImGui::PushFont(panel.input.fonts.bold);
  ImGui::TextColored(as_vec4(palette::kTextDim), "%s", fitted(topic, width).c_str());
  ImGui::PopFont();
  tag_last_item(panel.tags, "scenes/topic/" + topic, topic);
}

/// Draws the topics above a row of cards.
void topic_line(const Panel& panel, std::span<const SceneCard* const> row, float pitch) {
  const float left = ImGui::GetCursorPosX(), top = ImGui::GetCursorPosY();
  for (std::size_t i = 0; i < row.size(); ++i) {
    if (i > 0 && row[i]->topic == row[i - 1]->topic) continue;
    std::size_t end = i + 1;
    while (end < row.size() && row[end]->topic == row[i]->topic) ++end;
    ImGui::SetCursorPos({left + static_cast<float>(i) * pitch, top});
    topic_heading(panel, row[i]->topic, static_cast<float>(end - i) * pitch - kGap * ui_scale(panel));
  }
}

std::vector<std::string> names_of(std::span<const SceneCard* const> cards) {
  std::vector<std::filesystem::path> files;
  for (const SceneCard* card : cards) files.push_back(card->file);
  return scene_names(files);
}

/// Draws the cards. Returns the clicked one, or nullptr.
const SceneCard* card_list(Panel& panel, std::span<const SceneCard* const> cards, bool searched) {
  SceneBrowser& browser = panel.state.browser;
  const float gap = kGap * ui_scale(panel), room = ImGui::GetContentRegionAvail().x;
  const auto columns =
      std::max<std::size_t>(1, static_cast<std::size_t>((room + gap) / (kMinCardWidth * ui_scale(panel) + gap)));
  const float width = std::floor((room + gap) / static_cast<float>(columns) - gap);
  const std::vector<CardRow> rows = card_rows(cards.size(), columns);
  const std::vector<std::string> names = names_of(cards);
  const bool moved = move_card_choice(browser, rows) || searched;
  const SceneCard* clicked = nullptr;
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {gap, gap});
  for (const CardRow& row : rows) {
    topic_line(panel, cards.subspan(row.first, row.count), width + gap);
    for (std::size_t i = row.first; i < row.first + row.count; ++i) {
      if (i > row.first) ImGui::SameLine();
      if (scene_card(panel, *cards[i], names[i], i == browser.chosen, width)) clicked = cards[i];
      if (i == browser.chosen && moved) ImGui::SetScrollHereY();
    }
  }
  ImGui::PopStyleVar();
  return clicked;
}

/// Describes the chosen scene in two lines.
void about(Panel& panel, const SceneCard* card) {
  const std::string text = card ? card->description : "No scene matches.";
  ImGui::BeginChild("##about", {0, 2.2f * ImGui::GetTextLineHeightWithSpacing()});
  wrapped_text(text, card && card->readable ? palette::kText : palette::kWarning);
  tag_last_item(panel.tags, "scenes/about", text);
  ImGui::EndChild();
}

}  // namespace

void draw_scenes_dialog(Panel& panel) {
  SceneBrowser& browser = panel.state.browser;
  const float scale = ui_scale(panel), line = ImGui::GetTextLineHeightWithSpacing();
  const ImVec2 window = ImGui::GetIO().DisplaySize;
  if (!begin_dialog(panel, "Scenes", browser.shown, std::min(kMaxWidth, kWindowPart * window.x / scale))) return;
  const bool searched = search_field(panel, browser);
  const std::vector<const SceneCard*> cards = shown_cards(panel.input.scene_cards, browser.text.data());
  ImGui::BeginChild("##cards", {0, kWindowPart * window.y - kLinesAround * line});
  const SceneCard* picked = card_list(panel, cards, searched);
  ImGui::EndChild();
  const SceneCard* chosen = browser.chosen < cards.size() ? cards[browser.chosen] : nullptr;
  about(panel, chosen);
  const float width = 120 * scale;
  if (text_button(panel, "scenes/open", "Open", width) || ImGui::IsKeyPressed(key::kEnter, false)) picked = chosen;
  ImGui::SameLine();
  const bool other = text_button(panel, "scenes/other", "Other file…", width);
  ImGui::SameLine();
  const bool cancelled =
      text_button(panel, "scenes/cancel", "Cancel", width) || ImGui::IsKeyPressed(key::kEscape, false);
  if (picked) issue(panel, {.name = "file.open_path", .path = picked->file});
  if (other) panel.state.show_open = true;
  if (picked || other || cancelled) {
    browser = {};
    ImGui::CloseCurrentPopup();
  }
  ImGui::EndPopup();
}

}  // namespace griffith::ui
