#include "ui/model/command_search.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <string>
#include <utility>

#include "sim/core/number_text.h"

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

bool is_count(double value, double least, double most) {
  return value == std::round(value) && value >= least && value <= most;
}

/// Describes the numbers that an argument of a command consists of; empty for one without numbers.
std::string numbers_text(CommandArgument argument) {
  switch (argument) {
    case CommandArgument::step:
      return "a whole number from 0 to " + std::to_string(kMaxAskedSteps);
    case CommandArgument::cursor:
      return "two numbers: the place in the view, each from 0 to 1";
    case CommandArgument::array:
      return "four numbers: how many, from 2 to " + std::to_string(kMaxArray) + ", and the offset x y z in meters";
    default:
      return {};
  }
}

}  // namespace

CommandQuery parse_command_query(std::string_view text) {
  CommandQuery query{std::string(text), {}};
  for (;;) {
    while (query.letters.ends_with(' ')) query.letters.pop_back();
    const std::size_t start = query.letters.find_last_of(' ') + 1;  // 0 without a blank
    const std::optional<double> number = number_in(std::string_view(query.letters).substr(start));
    if (!number || start == 0) break;
    query.numbers.insert(query.numbers.begin(), *number);
    query.letters.resize(start);
  }
  return query;
}

std::optional<Command> with_numbers(const CommandInfo& info, const std::vector<double>& numbers) {
  Command command{.name = info.with_path.empty() ? info.name : info.with_path};
  const std::size_t count = numbers.size();
  if (info.argument == CommandArgument::step && count == 1 && is_count(numbers[0], 0, kMaxAskedSteps)) {
    command.step = static_cast<std::int64_t>(numbers[0]);
  } else if (info.argument == CommandArgument::cursor && count == 2) {
    command.cursor = Vec2(numbers[0], numbers[1]);
    if (command.cursor.minCoeff() < 0 || command.cursor.maxCoeff() > 1) return std::nullopt;
  } else if (info.argument == CommandArgument::array && count == 4 && is_count(numbers[0], 2, kMaxArray)) {
    command.step = static_cast<std::int64_t>(numbers[0]);
    command.offset = Vec3(numbers[1], numbers[2], numbers[3]);
  } else {
    return std::nullopt;
  }
  return command;
}

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

namespace {

/// Returns the commands that are offered and match, best first.
std::vector<const CommandInfo*> best_matches(std::span<const CommandInfo> commands, std::string_view query,
                                             const auto& is_offered) {
  std::vector<std::pair<int, const CommandInfo*>> scored;
  for (const CommandInfo& info : commands) {
    if (!is_offered(info)) continue;
    if (const std::optional<int> score = command_score(info, query)) scored.emplace_back(*score, &info);
  }
  std::ranges::stable_sort(scored, [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<const CommandInfo*> found;
  for (const auto& [score, info] : scored) found.push_back(info);
  return found;
}

}  // namespace

std::vector<const CommandInfo*> matching_commands(std::span<const CommandInfo> commands, std::string_view text) {
  const CommandQuery query = parse_command_query(text);
  return best_matches(commands, query.letters, [&](const CommandInfo& info) {
    return query.numbers.empty() ? info.menu != Menu::none : with_numbers(info, query.numbers).has_value();
  });
}

std::string problem_of_query(std::span<const CommandInfo> commands, std::string_view text) {
  const CommandQuery query = parse_command_query(text);
  const auto found = best_matches(commands, query.letters, [](const CommandInfo& info) {
    return info.menu != Menu::none || !numbers_text(info.argument).empty();
  });
  if (query.numbers.empty() || found.empty()) return "No command matches.";
  const std::string numbers = numbers_text(found.front()->argument);
  return std::string(found.front()->label) + " takes " + (numbers.empty() ? "no numbers" : numbers) + ".";
}

}  // namespace griffith::ui
