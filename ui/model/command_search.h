#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ui/model/commands.h"

namespace griffith::ui {

/// Scores how well the letters of `query` occur in `text`, in order and in any case. Higher is better; letters that
/// begin words or are adjacent score most. Empty if a letter is missing.
std::optional<int> match_score(std::string_view text, std::string_view query);

/// Text of the palette: letters of a command, then numbers for its argument, as in "array 4 0.5 0 0".
struct CommandQuery {
  std::string letters;
  std::vector<double> numbers;
};
CommandQuery parse_command_query(std::string_view text);

/// Returns the command with these numbers as its argument: steps, a point of the view, or the number and offset of an
/// array. Empty if it takes others, or as many in another range.
std::optional<Command> with_numbers(const CommandInfo& info, const std::vector<double>& numbers);

/// Returns the menu commands whose title, menu or help matches, best first; all commands if `text` is empty. With
/// numbers, those that take them, also if they are in no menu.
std::vector<const CommandInfo*> matching_commands(std::span<const CommandInfo> commands, std::string_view text);
/// Explains why no command matches: the numbers that the one with such letters takes.
std::string problem_of_query(std::span<const CommandInfo> commands, std::string_view text);

}  // namespace griffith::ui
