#include "ui/model/scene_browser.h"

#include <algorithm>
#include <cctype>
#include <sstream>

namespace griffith::ui {
namespace {

bool holds_word(std::string_view text, std::string_view word) {
  const auto same = [](char a, char b) {
    return std::tolower(static_cast<unsigned char>(a)) == std::tolower(static_cast<unsigned char>(b));
  };
  return !std::ranges::search(text, word, same).empty();
}

bool holds_words(const SceneCard& card, std::string_view text) {
  std::istringstream words{std::string(text)};
  const std::string all =
      card.title + "\n" + card.topic + "\n" + card.description + "\n" + card.file.filename().string();
  for (std::string word; words >> word;)
    if (!holds_word(all, word)) return false;
  return true;
}

}  // namespace

std::vector<const SceneCard*> shown_cards(std::span<const SceneCard> cards, std::string_view text) {
  std::vector<std::string_view> topics;
  for (const SceneCard& card : cards)
    if (std::ranges::find(topics, card.topic) == topics.end()) topics.emplace_back(card.topic);
  std::vector<const SceneCard*> shown;
  for (const std::string_view topic : topics)
    for (const SceneCard& card : cards)
      if (card.topic == topic && holds_words(card, text)) shown.push_back(&card);
  return shown;
}

std::vector<CardRow> card_rows(std::size_t cards, std::size_t columns) {
  std::vector<CardRow> rows;
  for (std::size_t first = 0; first < cards; first += columns)
    rows.push_back({first, std::min(columns, cards - first)});
  return rows;
}

std::size_t moved_choice(std::span<const CardRow> rows, std::size_t chosen, int right, int down) {
  if (rows.empty()) return 0;
  const auto clamped = [](std::ptrdiff_t place, std::size_t count) {
    return static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(place, 0, static_cast<std::ptrdiff_t>(count) - 1));
  };
  chosen = clamped(static_cast<std::ptrdiff_t>(chosen) + right, rows.back().first + rows.back().count);
  const auto row = std::ranges::find_if(rows, [&](const CardRow& r) { return chosen < r.first + r.count; });
  const CardRow& target = rows[clamped(row - rows.begin() + down, rows.size())];
  return &target == &*row ? chosen : target.first + std::min(chosen - row->first, target.count - 1);
}

}  // namespace griffith::ui
