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
  std::string description;          ///< in a sentence or two; of a file that cannot be read, why
  bool readable = true;             ///< the file holds a scene
  ImTextureID thumbnail = nullptr;  ///< 16:9, first row on top; null: there is none yet
};

/// What the browser of scenes shows.
struct SceneBrowser {
  bool shown = false;
  std::array<char, 64> text = {};  ///< words that the shown scenes have
  std::size_t chosen = 0;          ///< among those that are shown
};

/// Cards side by side.
struct CardRow {
  std::size_t first = 0, count = 0;  ///< among the shown ones
  bool operator==(const CardRow&) const = default;
};

/// The cards that have each word of `text` in title, topic, description or the file's name, whatever the case. Those of
/// a topic stand together; topics and their cards stand in the order in which they come.
std::vector<const SceneCard*> shown_cards(std::span<const SceneCard> cards, std::string_view text);

/// Lays `cards` of them out, `columns` side by side. `columns`: 1 or more.
std::vector<CardRow> card_rows(std::size_t cards, std::size_t columns);

/// The card that is so many to the right, or rows down, of the chosen one; at the ends of all rows the last there is.
std::size_t moved_choice(std::span<const CardRow> rows, std::size_t chosen, int right, int down);

}  // namespace griffith::ui
