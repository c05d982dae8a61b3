#pragma once

#include <imgui.h>

#include <array>
#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace griffith::ui {

/// A scene file as the browser shows it.
struct SceneCard {
  std::filesystem::path file;
  std::string title, topic;
  std::string description;          ///< one or two sentences; for an unreadable file the error
  bool readable = true;             ///< true if the file holds a scene
  ImTextureID thumbnail = nullptr;  ///< 16:9, first row on top; null: not available yet
};

/// State of the scene browser.
struct SceneBrowser {
  bool shown = false;
  std::array<char, 64> text = {};  ///< words that the shown scenes contain
  std::size_t chosen = 0;          ///< index among the shown scenes
};

/// Cards side by side.
struct CardRow {
  std::size_t first = 0, count = 0;  ///< range of the shown cards
  bool operator==(const CardRow&) const = default;
};

/// Returns the cards that contain each word of `text` in title, topic, description or file name, in any case. Cards of
/// a topic are adjacent; topics and their cards keep their order.
std::vector<const SceneCard*> shown_cards(std::span<const SceneCard> cards, std::string_view text);

/// Arranges `cards` cards in rows of `columns` >= 1.
std::vector<CardRow> card_rows(std::size_t cards, std::size_t columns);

/// Returns the index of the card `right` columns and `down` rows from the chosen one, kept within the rows.
std::size_t moved_choice(std::span<const CardRow> rows, std::size_t chosen, int right, int down);

}  // namespace griffith::ui
