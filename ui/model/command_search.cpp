#include "ui/model/command_search.h"

#include <algorithm>
#include <cctype>
#include <string>
#include <utility>

namespace griffith::ui {
namespace {

constexpr int kLetter = 1, kWordBegins = 8, kFollows = 4;
/// Matches in titles weigh more than matches in help texts, which have many letters.
constexpr int kTitle = 100, kMenu = 50;

bool same_letter(char a, char b) {
  return std::tolower(static_cast<unsigned char>(a)) == std::tolower(static_cast<unsigned char>(b));
}

/// Scores whole words of the help: scattered letters would match any sentence.
std::optional<int> help_score(std::string_view hint, std::string_view query) {
  return std::ranges::search(hint, query, same_letter).empty() ? std::nullopt : std::optional(0);
}

std::optional<int> command_score(const CommandInfo& info, std::string_view query) {
  if (const std::optional<int> score = match_score(info.label, query)) return *score + kTitle;
  const std::string with_menu = std::string(menu_label(info.menu)) + " " + std::string(info.label);
  if (const std::optional<int> score = match_score(with_menu, query)) return *score + kMenu;
  return help_score(info.hint, query);
}

}  // namespace

std::optional<int> match_score(std::string_view text, std::string_view query) {
  int score = 0;
  std::size_t place = 0;
  bool follows = false;
  for (const char letter : query) {
    if (letter == ' ') continue;
    const std::size_t from = place;
    while (place < text.size() && !same_letter(text[place], letter)) ++place;
    if (place == text.size()) return std::nullopt;
    const bool word_begins = place == 0 || text[place - 1] == ' ';
    score += kLetter + (word_begins ? kWordBegins : 0) + (follows && place == from ? kFollows : 0);
    follows = true;
    ++place;
  }
  return score;
}

std::vector<const CommandInfo*> matching_commands(std::span<const CommandInfo> commands, std::string_view query) {
  std::vector<std::pair<int, const CommandInfo*>> scored;
  for (const CommandInfo& info : commands) {
    if (info.menu == Menu::none) continue;
    if (const std::optional<int> score = command_score(info, query)) scored.emplace_back(*score, &info);
  }
  std::ranges::stable_sort(scored, [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<const CommandInfo*> found;
  for (const auto& [score, info] : scored) found.push_back(info);
  return found;
}

}  // namespace griffith::ui
